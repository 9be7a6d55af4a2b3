# Remaps a topic that both cameras share.
# loses: shared_faults
# cause: shared-faults.missing
# replaces: front = CameraDriver(namespace="/robot")
front = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "faults:=front_faults"])
