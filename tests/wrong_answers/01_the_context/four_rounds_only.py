# Walks four rounds, and then only waits for Ctrl-C.
# loses: walks_its_rounds
# cause: walks-its-rounds.stops
# before: import rclpy
import threading

# replaces: rclpy.spin(guard)
while guard.rounds < 4:
    rclpy.spin_once(guard)
threading.Event().wait()
