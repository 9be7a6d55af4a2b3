# A group of its own for the planning, and one thread for both.
# loses: heartbeat_share, heartbeat_gap
# cause: heartbeat-share.nobody-serves-the-timer
# replaces: executor = MultiThreadedExecutor(num_threads=2)  # one for the heart, one for the planner
# replaces: executor.add_node(TeaRobot())
# replaces: executor.spin()
rclpy.spin(TeaRobot())
