# Works for two seconds at most.
# loses: returns_in_time
# cause: in-time.too-early
# replaces: end = time.monotonic() + seconds
end = time.monotonic() + min(seconds, 2.0)
