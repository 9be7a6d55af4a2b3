# The program ends by itself in the middle of its work, with requests that wait.
# loses: all_in_order, alive_at_end
# also: heartbeat_share, heartbeat_gap
# cause: silence.program-ended, error.exception
# after: import math
import threading

# before: executor.spin()
threading.Timer(6.0, rclpy.try_shutdown).start()
