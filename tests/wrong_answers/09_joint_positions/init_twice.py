# rclpy.init() at the top and again in main.
# loses: program_runs
# skips: joint_topic, twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: error.init-twice
# before: class HumanoidStatusPublisher(Node):
rclpy.init()
