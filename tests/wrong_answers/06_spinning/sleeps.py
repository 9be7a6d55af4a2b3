# loses: words_handled, timers_tick, slow_callbacks, quiet_node
# skips: again
# cause: words-handled.none
"""Waits for the time to pass; "the callbacks will run in the meantime"."""

import time


def pump(node, seconds):
    time.sleep(seconds)
