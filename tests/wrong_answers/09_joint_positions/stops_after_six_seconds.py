# The program ends after six real seconds: when robot time is over, and before eight real ones are.
# loses: alive_at_end
# cause: alive-at-end.ended
# soak: yes
# after: import random
import time

# replaces: rclpy.spin(HumanoidStatusPublisher())
node = HumanoidStatusPublisher()
end = time.monotonic() + 6.0
while time.monotonic() < end:
    rclpy.spin_once(node, timeout_sec=0.1)
