# Ends by itself after two seconds: nothing is wrong with the reports that came.
# loses: shared_faults, alive_at_end
# cause: x.y
# before: import rclpy
import time

# replaces: executor.spin()
evening = time.monotonic() + 2.0
while time.monotonic() < evening:
    executor.spin_once(timeout_sec=0.1)
