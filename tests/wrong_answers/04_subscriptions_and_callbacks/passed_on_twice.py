# Publishes each good reading twice.
# loses: in_order
# cause: in-order.repeated
# after: self.battery_publisher.publish(message)
self.battery_publisher.publish(message)
