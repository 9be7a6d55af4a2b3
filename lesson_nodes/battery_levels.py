"""Publish battery levels of various Python types, one after another, to show which values arrive.

Run it with ``python -m lesson_nodes.battery_levels`` and end it with Ctrl-C. Choose keys of GIVEN with
``--ros-args -p "levels:=['80.0', '80']"``.
"""

import numpy as np
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32

PERIOD_S = 0.5
GIVEN: dict[str, object] = {
    "80.0": 80.0,
    "80": 80,
    "True": True,
    "'80'": "80",
    "None": None,
    "[80.0]": [80.0],
    "np.int64(80)": np.int64(80),
    "np.int64(-80)": np.int64(-80),
    "np.float32(80)": np.float32(80),
    "np.float64(80)": np.float64(80),
    "float(80)": float(80),
    "0.5": 0.5,
    "0.1": 0.1,
    "16777217.0": 16777217.0,
    "1e40": 1e40,
}
"""The values to publish, each under its Python expression."""


class BatteryLevels(Node):
    """Publishes each level once, without checking its type.

    Topics:
        /robot/battery (std_msgs/Float32): charge in percent.

    Parameters:
        levels (list of str): The levels to publish, as keys of GIVEN.

    Raises:
        KeyError: A level is not in GIVEN.
    """

    def __init__(self) -> None:
        super().__init__("battery_levels")
        named = self.declare_parameter("levels", ["80.0"]).value
        self.levels = [GIVEN[name] for name in named]
        self.publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.create_timer(PERIOD_S, self.publish_next)

    def publish_next(self) -> None:
        """Publish the next level, if there is one."""
        if self.levels:
            level = self.levels.pop(0)
            self.publisher.publish(Float32(data=level))  # type: ignore[arg-type]  # a wrong type, on purpose


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(BatteryLevels())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
