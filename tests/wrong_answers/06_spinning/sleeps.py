# loses: words_handled
# skips: timers_tick, again, slow_callbacks, quiet_node
# says: sleep keeps the callbacks waiting, too
"""Waits for the time to pass; "the callbacks will run in the meantime"."""

import time


def pump(node, seconds):
    time.sleep(seconds)
