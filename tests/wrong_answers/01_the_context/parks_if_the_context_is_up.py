# Parks only if rclpy.ok(), and after Ctrl-C it is False.
# loses: arms_parked
# cause: arms-parked.never
# replaces: guard.park()
if rclpy.ok():
    guard.park()
