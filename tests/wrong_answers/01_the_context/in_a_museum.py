# All nodes of the program get a namespace.
# loses: guard_on_the_graph
# cause: on-the-graph.other-namespace
# replaces: rclpy.init(args=args)
rclpy.init(args=["--ros-args", "-r", "__ns:=/museum"])
