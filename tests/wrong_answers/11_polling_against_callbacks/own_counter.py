# The callback counts for itself, from 0.
# loses: none_missed, once_in_order
# cause: none-missed.no-touch
# after: super().__init__("touch_monitor")
self.count = 0

# replaces: self.seen_publisher.publish(Int32(data=touch.data))
self.seen_publisher.publish(Int32(data=self.count))
self.count += 1
