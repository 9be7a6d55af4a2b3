# Shuts down what Ctrl-C has shut down already.
# loses: ends_cleanly
# cause: error.shutdown-twice
# replaces: rclpy.try_shutdown()
rclpy.shutdown()
