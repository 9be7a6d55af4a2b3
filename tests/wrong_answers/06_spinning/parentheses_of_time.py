# `time.monotonic` without its parentheses is a function and no number.
# loses: program_runs
# skips: returns, returns_in_time, words_handled, timers_tick, again, slow_callbacks, quiet_node, easy_on_the_processor, nothing_left_running
# skips: easy_on_the_processor, nothing_left_running
# cause: error.exception
# says: TypeError
# says: line 18
# replaces: end = time.monotonic() + seconds
end = time.monotonic + seconds
