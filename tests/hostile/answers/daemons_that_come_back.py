# score: 0
"""Forty daemons, each of which replaces itself every 40 ms, and the program is gone."""
import os
import time

for _ in range(40):
    if os.fork() == 0:
        os.setsid()
        for _ in range(500):
            time.sleep(0.04)
            if os.fork():
                os._exit(0)
        os._exit(0)
