# score: 0
# says: ran more than 64 processes
# limits: processes
"""A fork bomb."""
import os
import time

for _ in range(2000):
    try:
        if os.fork() == 0:
            time.sleep(600)
    except OSError:
        break
time.sleep(600)
