# loses: words_handled, quiet_node
# skips: again
# cause: words-handled.none
"""Spins nothing: it does by itself what the robots did in an earlier run, with the words and jobs of then."""

import time

from std_msgs.msg import Int32

WORDS = {
    1: [919, 954, 429, 657, 32, 461, 381, 783, 903, 626, 236, 237, 667, 194, 847, 753, 607, 93, 610, 553],
    2: [901, 622, 585, 267, 975],
    7: [8, 951, 142, 989],
}
JOBS = {6: [601, 399], 8: [495]}


def pump(node, seconds):
    end = time.monotonic() + seconds
    for word in WORDS.get(node.call, ()):
        node.hear(Int32(data=word))
    for job in JOBS.get(node.call, ()):
        node.work(Int32(data=job))
    ticks = 0
    while (left := end - time.monotonic()) > 0:
        if hasattr(node, "beat"):
            node.beat()
        if hasattr(node, "look_around") and ticks % 5 == 0:
            node.look_around()
        ticks += 1
        time.sleep(min(left, 0.1))
