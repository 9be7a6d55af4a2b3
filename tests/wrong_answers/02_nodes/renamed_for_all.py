# Renames with arguments of the whole program, so every node gets the new name.
# loses: front_node, rear_node, nobody_else
# skips: front_pictures, rear_pictures, shared_faults
# cause: on-the-graph.name-of-another
# says: /robot/camera
# says: /robot/rear_camera
# before: from typing import Any
import sys

# replaces: rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
rear = CameraDriver(namespace="/robot")

# replaces: rclpy.init(args=args)
rclpy.init(args=[*sys.argv, "--ros-args", "-r", "__node:=rear_camera"])
