# Catches Ctrl-C inside of the loop and goes on.
# loses: ends_cleanly
# cause: exits-cleanly.runs-on
# replaces: try:
# replaces:     rclpy.spin(humanoid)
# replaces: except (KeyboardInterrupt, ExternalShutdownException):
# replaces:     pass  # someone ended the program, which isn't an error
# replaces: finally:
# replaces:     rclpy.try_shutdown()  # Ctrl-C may have shut the context down already
while True:
    try:
        rclpy.spin_once(humanoid, timeout_sec=0.2)
    except BaseException:
        pass
