# Gives the node a name that the driver gives it already.
# loses: program_runs
# skips: front_node, rear_node, front_pictures, rear_pictures, shared_faults, nobody_else, alive_at_end
# cause: error.exception
# says: multiple values
# replaces: rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
rear = CameraDriver(node_name="rear_camera", namespace="/robot")
