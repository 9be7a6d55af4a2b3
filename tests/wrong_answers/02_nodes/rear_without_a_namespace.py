# The second camera is in the namespace /.
# loses: rear_node, nobody_else
# skips: rear_pictures, shared_faults
# cause: on-the-graph.other-namespace
# replaces: rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
rear = CameraDriver(cli_args=["--ros-args", "-r", "__node:=rear_camera"])
