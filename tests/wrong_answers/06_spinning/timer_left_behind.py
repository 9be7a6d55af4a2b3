# Makes a timer for the end, and never destroys it.
# loses: nothing_left_running
# cause: nothing-left-running.left-behind
# after: end = time.monotonic() + seconds
node.create_timer(seconds, lambda: None)
