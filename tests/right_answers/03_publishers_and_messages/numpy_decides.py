"""Lets NumPy say what kind of thing it is."""

import numpy as np
from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self, **kwargs):
        super().__init__("battery_publisher", **kwargs)
        self.publisher_ = self.create_publisher(Float32, "/robot/battery", 100)

    def publish_level(self, level):
        value = np.asarray(level)
        if value.shape != () or value.dtype.kind not in "iuf":
            raise TypeError("level must be one number")
        if not np.isfinite(value):
            raise ValueError("level must be finite")
        self.publisher_.publish(Float32(data=value.item() * 1.0))
        self.get_logger().info(f"Battery: {value} %")
