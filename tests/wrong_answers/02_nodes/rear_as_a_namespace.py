# A namespace in the place of a new name.
# loses: rear_node, nobody_else
# skips: rear_pictures, shared_faults
# cause: on-the-graph.slash-for-underscore
# replaces: rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
rear = CameraDriver(namespace="/robot/rear")
