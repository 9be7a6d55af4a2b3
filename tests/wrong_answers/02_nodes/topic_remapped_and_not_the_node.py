# The topic gets the new name, and the node keeps its own.
# loses: front_node, rear_node, nobody_else
# skips: front_pictures, rear_pictures, shared_faults
# cause: on-the-graph.twice
# says: /robot/camera
# replaces: rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "~/frame:=/robot/rear_camera/frame"])
