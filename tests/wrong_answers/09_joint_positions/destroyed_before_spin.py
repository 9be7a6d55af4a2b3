# The node is destroyed, then spun. It may be gone before anybody has seen it.
# loses: program_runs
# skips: joint_topic, twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: program-runs.node-destroyed, program-runs.no-node
# replaces: rclpy.spin(HumanoidStatusPublisher())
node = HumanoidStatusPublisher()
node.destroy_node()
rclpy.spin(node)
