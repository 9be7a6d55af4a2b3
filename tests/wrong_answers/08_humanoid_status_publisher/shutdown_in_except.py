# Shuts down what Ctrl-C has shut down already.
# loses: ends_cleanly
# cause: error.shutdown-twice
# says: exit code 1
# after: import random
import time

# replaces:     pass  # someone ended the program, which isn't an error
# replaces: finally:
# replaces:     rclpy.try_shutdown()  # Ctrl-C may have shut the context down already
    time.sleep(0.5)
    rclpy.shutdown()
