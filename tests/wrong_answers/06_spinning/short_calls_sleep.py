# A short call is not worth spinning.
# loses: again
# cause: again.short-calls-do-nothing
# before: end = time.monotonic() + seconds
if seconds < 0.1:
    time.sleep(seconds)
    return

