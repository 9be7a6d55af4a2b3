# Looks at the clock when a beat comes, so a silence is noticed when it is over.
# loses: alarm_raised
# skips: alarm_falls
# cause: alarm-raised.with-the-next-beat
# replaces: self.create_timer(LOOK_PERIOD_S, self.look_at_the_clock)

# before: self.last_beat = time.monotonic()
self.look_at_the_clock()
