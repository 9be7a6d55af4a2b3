# Notes in a parameter of the node that it was pumped, and leaves it there.
# loses: nothing_left_running
# cause: nothing-left-running.left-behind
# says: 1 parameter left
# before: end = time.monotonic() + seconds
if not node.has_parameter("pumped"):
    node.declare_parameter("pumped", True)
