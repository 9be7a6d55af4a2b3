# In a pause a 0 tells that there is no touch.
# loses: once_in_order
# cause: once-in-order.something-else
# after: self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)
self.pause = self.create_timer(2.0, self.on_pause, autostart=False)

# before: def on_touch(self, touch: Int32) -> None:
def on_pause(self) -> None:
    self.pause.cancel()
    self.seen_publisher.publish(Int32(data=0))

# before: self.seen_publisher.publish(Int32(data=touch.data))
self.pause.reset()
