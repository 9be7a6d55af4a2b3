"""The ROS 2 nodes that the lessons run: one module per node, each also a program of its own."""
