# Touches are collected, and reported when there are twelve.
# loses: quick
# cause: quick.collected
# after: super().__init__("touch_monitor")
self.touches: list[int] = []

# replaces: self.seen_publisher.publish(Int32(data=touch.data))
self.touches.append(touch.data)
if len(self.touches) == 12:
    for number in self.touches:
        self.seen_publisher.publish(Int32(data=number))
    self.touches.clear()
