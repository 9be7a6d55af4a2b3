"""Show how spinning ends, depending on what ended it.

Run it with ``python -m lesson_nodes.ends_of_spin SIGTERM rclpy.spin``.
"""

import os
import signal
import sys
import threading
import time

import rclpy
from rclpy.executors import SingleThreadedExecutor

from lesson_nodes.night_guard import NightGuard

CAUSES = {
    "Ctrl-C (SIGINT)": lambda: os.kill(os.getpid(), signal.SIGINT),
    "SIGTERM": lambda: os.kill(os.getpid(), signal.SIGTERM),
    "shutdown in a thread": lambda: rclpy.shutdown(),
}
WAYS = ("rclpy.spin", "executor.spin")


def main(cause: str, way: str) -> None:
    """Spin a guard until the cause ends it. Print whether the context is valid, and the exception, if any."""
    rclpy.init()
    guard = NightGuard()
    threading.Timer(1.2, CAUSES[cause]).start()
    came = "it returned"
    try:
        if way == "rclpy.spin":
            rclpy.spin(guard)
        else:
            executor = SingleThreadedExecutor()
            executor.add_node(guard)
            executor.spin()
    except BaseException as error:
        came = type(error).__name__
    time.sleep(0.3)
    print("ok:", rclpy.ok())
    print(came)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
