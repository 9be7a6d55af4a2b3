# Remembers the seconds of the first call.
# loses: returns_in_time, again, slow_callbacks, quiet_node
# cause: in-time.first-time-kept
# before: def pump(node: Node, seconds: float) -> None:
ASKED: list[float] = []


# replaces: end = time.monotonic() + seconds
ASKED.append(seconds)
end = time.monotonic() + ASKED[0]
