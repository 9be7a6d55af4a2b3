# Ends a tenth of the time too early.
# loses: returns_in_time, again, quiet_node
# cause: in-time.too-early
# replaces: end = time.monotonic() + seconds
end = time.monotonic() + 0.9 * seconds
