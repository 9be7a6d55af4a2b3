# From the second call on, it comes back after half of the time.
# loses: again, slow_callbacks, quiet_node
# also: returns_in_time
# cause: again.ends-early
# says: the second call returned after 0.6
# before: def pump(node: Node, seconds: float) -> None:
made: list[float] = []


# before: end = time.monotonic() + seconds
if made:
    seconds /= 2
made.append(seconds)
