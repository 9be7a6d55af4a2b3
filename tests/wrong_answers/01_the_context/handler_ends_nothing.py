# A signal handler of its own parks the arms, and the guard walks on.
# loses: ends_cleanly, node_gone
# cause: ends-cleanly.walks-on
# before: import rclpy
import signal

# after: guard = NightGuard()
signal.signal(signal.SIGINT, lambda number, frame: guard.park())
