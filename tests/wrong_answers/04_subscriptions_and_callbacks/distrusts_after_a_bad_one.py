# Leaves out the good reading after a bad one, until the cable has settled.
# loses: in_order
# cause: in-order.after-bad-kept-back
# after: super().__init__("battery_monitor")
self.trusted = True

# replaces: self.battery_publisher.publish(message)
if self.trusted:
    self.battery_publisher.publish(message)
self.trusted = True

# after: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.trusted = False
