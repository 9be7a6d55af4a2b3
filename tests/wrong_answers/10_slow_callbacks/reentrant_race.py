# A reentrant group: requests are planned side by side, on one planner.
# loses: plans_right, all_in_order
# also: heartbeat_gap, heartbeat_share
# cause: plans-right.race
# replaces: from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.callback_groups import ReentrantCallbackGroup

# replaces: planning = MutuallyExclusiveCallbackGroup()
planning = ReentrantCallbackGroup()

# replaces: executor = MultiThreadedExecutor(num_threads=2)  # one for the heart, one for the planner
executor = MultiThreadedExecutor(num_threads=4)
