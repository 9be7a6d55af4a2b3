# The number of the next touch is reported.
# loses: none_missed, once_in_order
# cause: none-missed.no-touch
# replaces: self.seen_publisher.publish(Int32(data=touch.data))
self.seen_publisher.publish(Int32(data=touch.data + 1))
