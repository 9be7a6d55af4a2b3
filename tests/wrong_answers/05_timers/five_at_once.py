# The right number of tilt values in a minute, but five at once every second.
# loses: tilt_count
# cause: rate.groups-with-silences
# replaces: self.create_timer(TILT_PERIOD_S, self.publish_tilt)
self.create_timer(1.0, self.publish_five)

# before: def publish_tilt(self) -> None:
def publish_five(self) -> None:
    for _ in range(5):
        self.publish_tilt()
