# The second camera is never made.
# loses: rear_node
# skips: rear_pictures, shared_faults
# cause: on-the-graph.never-made
# says: /robot/rear_camera
# replaces: rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
# replaces: return [front, rear]
return [front]
