# The number is kept in one byte.
# loses: none_missed, once_in_order
# cause: none-missed.cut-off
# replaces: self.seen_publisher.publish(Int32(data=touch.data))
self.seen_publisher.publish(Int32(data=touch.data % 256))
