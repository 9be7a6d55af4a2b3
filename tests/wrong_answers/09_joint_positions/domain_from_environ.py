# The program sets its own domain before init.
# loses: program_runs
# skips: joint_topic, twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: program-runs.other-domain
# says: domain 30
# after: import math
import os

# before: rclpy.init(args=args)
os.environ["ROS_DOMAIN_ID"] = "30"
