"""Send this process SIGINT, as Ctrl-C does, and print whether its context is still valid afterward.

Run it with ``python -m lesson_nodes.interrupted_sleep``.
"""

import os
import signal
import time

import rclpy


def main() -> None:
    """Initialize rclpy, interrupt a sleep with SIGINT, and check the context half a second later."""
    rclpy.init()
    try:
        os.kill(os.getpid(), signal.SIGINT)
        time.sleep(5)
    except KeyboardInterrupt:
        print("interrupted")
    time.sleep(0.5)
    print("in a program, the context is", "valid" if rclpy.ok() else "shut down")
    rclpy.try_shutdown()


if __name__ == "__main__":
    main()
