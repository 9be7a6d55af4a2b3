# score: 0
# limits: descriptors
"""Opens files in many processes, in none of them too many."""
import os
import time

for _ in range(15):
    if os.fork() == 0:
        held = [os.open("/dev/null", os.O_RDONLY) for _ in range(400)]
        time.sleep(60)
time.sleep(60)
