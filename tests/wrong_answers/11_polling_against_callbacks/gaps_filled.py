# Numbers that the skin has left out are reported, too.
# loses: once_in_order
# cause: once-in-order.gap-filled
# after: super().__init__("touch_monitor")
self.last = 0

# replaces: self.seen_publisher.publish(Int32(data=touch.data))
for number in range(self.last + 1, touch.data):
    if 0 < self.last:
        self.seen_publisher.publish(Int32(data=number))
self.last = touch.data
self.seen_publisher.publish(Int32(data=touch.data))
