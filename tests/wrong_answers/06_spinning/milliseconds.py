# Takes seconds for milliseconds.
# loses: returns
# skips: returns_in_time, timers_tick, again, slow_callbacks, quiet_node, easy_on_the_processor, nothing_left_running
# cause: returns.never
# replaces: end = time.monotonic() + seconds
end = time.monotonic() + seconds * 1000
