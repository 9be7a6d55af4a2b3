# The loop has become a timer, and it still looks.
# loses: none_missed, quick
# cause: none-missed.came-together
# after: super().__init__("touch_monitor")
self.last = 0
self.reported = 0
self.create_timer(0.2, self.look)

# before: def on_touch(self, touch: Int32) -> None:
def look(self) -> None:
    if self.last != self.reported:
        self.reported = self.last
        self.seen_publisher.publish(Int32(data=self.reported))

# replaces: self.seen_publisher.publish(Int32(data=touch.data))
self.last = touch.data
