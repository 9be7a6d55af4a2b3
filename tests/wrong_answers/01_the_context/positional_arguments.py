# init takes its arguments by keyword only.
# loses: program_runs
# skips: runs_until_told, walks_its_rounds, guard_on_the_graph, arms_parked, ends_cleanly, node_gone
# cause: error.exception
# says: takes 0 positional arguments
# before: import rclpy
import sys

# replaces: rclpy.init(args=args)
rclpy.init(sys.argv)
