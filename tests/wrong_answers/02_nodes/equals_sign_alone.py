# An equals sign without its colon.
# loses: program_runs
# skips: front_node, rear_node, front_pictures, rear_pictures, shared_faults, nobody_else, alive_at_end
# cause: error.ros-arguments
# replaces: rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node=rear_camera"])
