# Ends by itself after six seconds.
# loses: alive_at_end
# skips: ends_cleanly
# cause: alive-at-end.ended
# soak: yes
# after: import random
import time

# replaces: rclpy.spin(humanoid)
end = time.monotonic() + 6.0
while time.monotonic() < end:
    rclpy.spin_once(humanoid, timeout_sec=0.2)
