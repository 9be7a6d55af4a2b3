"""The ROS 2 nodes that the lessons run. Each module is also a program."""
