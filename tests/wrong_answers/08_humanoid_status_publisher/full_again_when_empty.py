# An empty battery is full again in the next message.
# loses: battery_arrives
# cause: never-rises.now-and-then
# says: to 100 at message
# before: message = Float32(data=self.battery_level)
if self.battery_level == 0.0:
    self.battery_level = 100.0
