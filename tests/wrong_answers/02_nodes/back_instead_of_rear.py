# Another new name than the one that was asked for.
# loses: rear_node, nobody_else
# skips: rear_pictures, shared_faults
# cause: on-the-graph.misspelled
# says: /robot/back_camera
# replaces: rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=back_camera"])
