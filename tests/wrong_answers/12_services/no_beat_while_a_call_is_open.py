# Leaves out the heartbeat while a call is open.
# loses: heartbeat_steady
# cause: heartbeat-steady.stops-during-a-call
# before: self.heartbeat_publisher.publish(String(data="alive"))
if self.open_call is not None:
    return

