# The tilt comes from a loop that sleeps, and its work of 60 ms comes on top.
# loses: tilt_count
# cause: rate.too-slow
# says: create_timer(0.2
# after: import math
import threading
import time

# replaces: self.create_timer(TILT_PERIOD_S, self.publish_tilt)
threading.Thread(target=self.sense, daemon=True).start()

# before: def publish_tilt(self) -> None:
def sense(self) -> None:
    while rclpy.ok():
        time.sleep(0.06)
        self.publish_tilt()
        time.sleep(0.2)
