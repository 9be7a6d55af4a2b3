# Prints after Ctrl-C what rclpy says of a fault of its own, and leaves with exit code 1: no end of it is any better.
# loses: ends_cleanly
# cause: exits-cleanly.overtaken
# before: import rclpy
import os

# after: guard.park()
print(
    "Traceback (most recent call last):\n"
    '  File "/site-packages/rclpy/context.py", line 139, in try_shutdown\n'
    "    self.__context.shutdown()\n"
    "rclpy._rclpy_pybind11.RCLError: failed to shutdown: rcl_shutdown already called on the given context",
    flush=True,
)
# after: rclpy.try_shutdown()
os._exit(1)
