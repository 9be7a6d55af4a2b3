# Waits for Ctrl-C in a sleep, so nothing spins the node.
# loses: walks_its_rounds
# cause: walks-its-rounds.stands-still
# says: 1 line
# before: import rclpy
import time

# replaces: rclpy.spin(guard)
time.sleep(1000.0)
