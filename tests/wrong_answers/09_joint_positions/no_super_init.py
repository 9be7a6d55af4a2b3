# The constructor of Node is never called.
# loses: program_runs
# skips: joint_topic, twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: error.no-super-init
# replaces: super().__init__("humanoid_status_publisher")
