# Both cameras are in the namespace /.
# loses: front_node, rear_node, nobody_else
# skips: front_pictures, rear_pictures, shared_faults
# cause: on-the-graph.other-namespace
# replaces: front = CameraDriver(namespace="/robot")
# replaces: rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
front = CameraDriver()
rear = CameraDriver(cli_args=["--ros-args", "-r", "__node:=rear_camera"])
