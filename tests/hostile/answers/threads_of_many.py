# score: 0
# limits: processes
"""Starts threads in many processes, in none of them too many: all programs of a machine share their numbers."""
import os
import threading
import time

threading.stack_size(65536)
for _ in range(40):
    if os.fork() == 0:
        try:
            for _ in range(60):
                threading.Thread(target=time.sleep, args=(60,), daemon=True).start()
        except RuntimeError:
            os._exit(0)
        time.sleep(60)
time.sleep(60)
