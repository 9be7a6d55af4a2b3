# Logs whole percents. There is no whole number for nan, and an error in a callback ends the program.
# loses: in_order, one_alarm
# cause: error.exception
# says: cannot convert float NaN to integer
# before: if EMPTY <= message.data <= FULL:
self.get_logger().info(f"{int(message.data)} %")
