# Puts the name into the namespace, so the node itself is still called camera.
# loses: rear_node, nobody_else
# skips: rear_pictures, shared_faults
# cause: on-the-graph.name-as-namespace
# replaces: rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
rear = CameraDriver(namespace="/robot/rear_camera")
