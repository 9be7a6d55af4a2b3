# Returns a little early, so that it is surely not late.
# loses: returns_in_time
# also: again, quiet_node
# cause: in-time.subtracted, in-time.too-early
# replaces: end = time.monotonic() + seconds
end = time.monotonic() + seconds - 0.07
