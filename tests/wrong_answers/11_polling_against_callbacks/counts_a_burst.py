# After touches that came together it also reports how many they were.
# loses: once_in_order
# cause: once-in-order.besides-all
# says: 11 was reported before
# after: super().__init__("touch_monitor")
self.together = 0
self.rest = self.create_timer(0.1, self.sum_up)

# replaces: self.seen_publisher.publish(Int32(data=touch.data))
self.seen_publisher.publish(Int32(data=touch.data))
self.together += 1
self.rest.reset()

# before: def on_touch(self, touch: Int32) -> None:
def sum_up(self) -> None:
    """Report how many touches came together."""
    self.rest.cancel()
    if self.together > 5:
        self.seen_publisher.publish(Int32(data=self.together))
    self.together = 0
