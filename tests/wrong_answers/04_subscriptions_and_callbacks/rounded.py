# Cuts off the decimals on the way.
# loses: in_order
# cause: in-order.changed
# replaces: self.battery_publisher.publish(message)
self.battery_publisher.publish(Float32(data=float(int(message.data))))
