# score: 10
"""A good answer that starts a hundred and sixty short processes: half of them it never waits for, half have lost their parent."""
import os
import time

for _ in range(80):
    if os.fork() == 0:
        os._exit(0)
    child = os.fork()
    if child == 0:
        if os.fork() == 0:
            time.sleep(0.05)
        os._exit(0)
    os.waitpid(child, 0)
@@GOOD@@
