# init is given a domain.
# loses: program_runs
# skips: joint_topic, twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: program-runs.other-domain
# says: domain 30
# replaces: rclpy.init(args=args)
rclpy.init(args=args, domain_id=30)
