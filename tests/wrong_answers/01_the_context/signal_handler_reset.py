# Gives Ctrl-C back to the system, so that no line runs after it.
# loses: arms_parked, ends_cleanly, node_gone
# cause: arms-parked.killed-by-ctrl-c
# before: import rclpy
import signal

# after: guard = NightGuard()
signal.signal(signal.SIGINT, signal.SIG_DFL)
