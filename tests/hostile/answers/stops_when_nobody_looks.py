# soak: yes
# loses: alive_at_end
"""Right for four real seconds, then gone."""
import os
import threading
import time

import rclpy


def leave():
    while not rclpy.ok():
        time.sleep(0.05)
    time.sleep(4.0)
    os._exit(0)


threading.Thread(target=leave, daemon=True).start()
@@GOOD@@
