# Rounds to whole percents. round() makes an int, and an int in a float field arrives as 0.0.
# loses: in_order
# cause: in-order.all-zero
# replaces: self.battery_publisher.publish(message)
self.battery_publisher.publish(Float32(data=round(message.data)))
