# Gives slow timers another period, so that they run in a short call, too.
# loses: nothing_left_running
# cause: nothing-left-running.changed
# says: period of a timer changed
# before: end = time.monotonic() + seconds
for timer in node.timers:
    timer.timer_period_ns = min(timer.timer_period_ns, 300_000_000)
