# Has heard of nan, and compares with it.
# loses: bad_kept_back, one_alarm
# cause: bad-kept-back.passed-on
# replaces: if EMPTY <= message.data <= FULL:
# replaces:     self.battery_publisher.publish(message)
# replaces: else:  # this includes nan, which isn't between any two numbers
# replaces:     self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
if message.data == float("nan") or message.data < EMPTY or message.data > FULL:
    self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
else:
    self.battery_publisher.publish(message)
