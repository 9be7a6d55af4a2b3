# Calls init at the top of the file, and in main() again.
# loses: program_runs
# skips: runs_until_told, walks_its_rounds, guard_on_the_graph, arms_parked, ends_cleanly, node_gone
# cause: error.init-twice
# after: ROUND_S = 0.5
rclpy.init()
