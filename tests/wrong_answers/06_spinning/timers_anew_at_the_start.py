# Starts the timers anew in each call, so that in a short one none is due.
# loses: again, nothing_left_running
# cause: again.timers-reset
# before: end = time.monotonic() + seconds
for timer in node.timers:
    timer.reset()
