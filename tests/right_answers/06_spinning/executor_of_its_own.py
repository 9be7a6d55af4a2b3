"""An executor for this one call, which lets go of the node afterwards."""

import time

from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node


def pump(node: Node, seconds: float) -> None:
    executor = SingleThreadedExecutor(context=node.context)
    executor.add_node(node)
    end = time.monotonic() + seconds
    try:
        while time.monotonic() < end:
            executor.spin_once(timeout_sec=max(0.0, end - time.monotonic()))
    finally:
        executor.remove_node(node)
        executor.shutdown()


def main() -> None:
    """Try it on a node that does nothing."""
    import rclpy

    rclpy.init()
    pump(Node("tried"), 1.0)
    rclpy.try_shutdown()


if __name__ == "__main__":
    main()
