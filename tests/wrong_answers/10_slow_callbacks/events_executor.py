# The newest executor, because it is said to be the fastest.
# loses: heartbeat_share, heartbeat_gap, plans_right, all_in_order
# cause: no-message.silent
# after: from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.experimental import EventsExecutor

# replaces: executor = MultiThreadedExecutor(num_threads=2)  # one for the heart, one for the planner
executor = EventsExecutor()
