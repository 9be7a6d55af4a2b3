# A timer makes one more node each time. All of them have the same name.
# loses: nobody_else
# cause: nobody-else.extra-node
# after: rear = CameraDriver(namespace="/robot", cli_args=["--ros-args", "-r", "__node:=rear_camera"])
watchdogs = []
front.create_timer(3.0, lambda: watchdogs.append(Node("watchdog", namespace="/robot")))
