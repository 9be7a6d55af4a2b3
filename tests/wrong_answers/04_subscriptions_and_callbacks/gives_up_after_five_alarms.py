# After five alarms it gives up, and passes nothing on any more.
# loses: in_order, one_alarm
# cause: in-order.stops
# after: self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
self.alarms = 0

# replaces: if EMPTY <= message.data <= FULL:
if self.alarms == 5:
    return
if EMPTY <= message.data <= FULL:

# replaces: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.alarms += 1
self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
