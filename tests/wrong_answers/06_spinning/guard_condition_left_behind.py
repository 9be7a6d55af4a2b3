# Makes a guard condition on the node, to wake it up, and leaves it there.
# loses: nothing_left_running
# cause: nothing-left-running.left-behind
# says: 1 guard condition left
# before: end = time.monotonic() + seconds
node.create_guard_condition(lambda: None)
