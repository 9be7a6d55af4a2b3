# One callback in each turn of a loop that sleeps: too few for both cameras.
# loses: front_pictures, rear_pictures, shared_faults
# cause: pictures.both-slow
# before: from typing import Any
import time

# replaces: executor.spin()
while rclpy.ok():
    executor.spin_once(timeout_sec=0.1)
    time.sleep(0.5)
