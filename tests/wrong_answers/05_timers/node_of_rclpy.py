# Node is imported from rclpy itself, where it isn't.
# loses: program_runs
# cause: error.name-in-other-module
# says: Node is in rclpy.node
# replaces: from rclpy.node import Node
from rclpy import Node
