# Asks with each beat of the heart, unless a call is open.
# loses: asks_every_second
# cause: asks-every-second.too-often
# says: 0.2
# replaces: self.create_timer(ASK_PERIOD_S, self.ask)
self.waited = 0

# after: self.heartbeat_publisher.publish(String(data="alive"))
self.ask()

# before: self.self_test.remove_pending_request(self.open_call)
self.waited += 1
if self.waited < 5:
    return

# after: self.open_call.add_done_callback(self.on_answer)
self.waited = 0
