# A hyphen is not allowed in a name.
# loses: program_runs
# skips: front_node, rear_node, front_pictures, rear_pictures, shared_faults, nobody_else, alive_at_end
# cause: error.ros-arguments
# says: parse remap rule
# replaces: rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear-camera"])
