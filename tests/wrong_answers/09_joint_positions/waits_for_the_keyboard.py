# The program asks how many joints there are.
# loses: program_runs
# skips: joint_topic, twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: error.reads-keyboard
# before: rclpy.init(args=args)
joints = int(input("How many joints? "))
