# Both nodes are there, but one of them is never spun.
# loses: rear_pictures, shared_faults
# cause: pictures.node-not-spun
# replaces: executor = SingleThreadedExecutor()
# replaces: for camera in make_cameras():
# replaces:     executor.add_node(camera)
front, rear = make_cameras()

# replaces: executor.spin()
rclpy.spin(front)
