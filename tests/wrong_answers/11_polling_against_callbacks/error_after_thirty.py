# A list of thirty places for the touches.
# loses: none_missed, alive_at_end
# cause: error.exception
# after: super().__init__("touch_monitor")
self.places = [0] * 30

# before: self.seen_publisher.publish(Int32(data=touch.data))
self.places.pop()
