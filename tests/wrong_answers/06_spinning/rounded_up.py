# Rounds the time up to whole seconds.
# loses: returns_in_time, slow_callbacks, quiet_node
# cause: in-time.too-late
# replaces: end = time.monotonic() + seconds
end = time.monotonic() + float(-(-seconds // 1))
