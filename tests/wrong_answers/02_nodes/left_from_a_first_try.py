# A camera of a first try is still there.
# loses: rear_node, nobody_else
# skips: rear_pictures, shared_faults
# cause: on-the-graph.twice
# says: /robot/rear_camera
# replaces: return [front, rear]
first_try = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
return [first_try, front, rear]
