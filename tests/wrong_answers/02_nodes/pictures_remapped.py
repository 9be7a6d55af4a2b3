# The pictures of the rear camera get another name, too.
# loses: rear_pictures
# cause: publishes.other-name
# says: remap only __node
# replaces: rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
rear = CameraDriver(
    namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera", "-r", "~/frame:=~/image"]
)
