# Works for half a second at least, however short the time.
# loses: returns_in_time
# cause: in-time.too-late
# replaces: end = time.monotonic() + seconds
end = time.monotonic() + max(seconds, 0.5)
