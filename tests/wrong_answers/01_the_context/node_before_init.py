# Makes the node first, and calls init afterwards.
# loses: program_runs
# skips: runs_until_told, walks_its_rounds, guard_on_the_graph, arms_parked, ends_cleanly, node_gone
# cause: error.not-initialized
# replaces: rclpy.init(args=args)
# replaces: guard = NightGuard()
guard = NightGuard()
rclpy.init(args=args)
