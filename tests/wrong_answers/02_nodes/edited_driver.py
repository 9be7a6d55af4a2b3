# Edits the driver to take a name and to use one topic.
# loses: front_pictures, rear_pictures
# cause: pictures.other-node
# says: /robot/camera/frame
# replaces: def __init__(self, **settings: Any) -> None:
# replaces:     super().__init__("camera", **settings)
def __init__(self, name: str) -> None:
    super().__init__(name, namespace="/robot")

# replaces: self.frame_publisher = self.create_publisher(String, "~/frame", 10)
self.frame_publisher = self.create_publisher(String, "/robot/camera/frame", 10)

# replaces: front = CameraDriver(namespace="/robot")
# replaces: rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
# replaces: return [front, rear]
return [CameraDriver("camera"), CameraDriver("rear_camera")]
