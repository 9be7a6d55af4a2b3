"""A callback group of its own for the pictures, two threads, and DDS keeps the newest picture."""

import math

import numpy as np
import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from rclpy.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import Image, Imu
from std_msgs.msg import String
from visualization_msgs.msg import Marker, MarkerArray

from workbook.models.slow import SlowDetector

NEWEST = QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)


class Watcher(Node):
    def __init__(self, model: SlowDetector) -> None:
        super().__init__("watcher")
        self.model = model
        self.row = 0
        self.down = False
        self.found = self.create_publisher(MarkerArray, "/robot/detections", 10)
        self.status = self.create_publisher(String, "/robot/status", 10)
        slow = MutuallyExclusiveCallbackGroup()
        self.create_subscription(Image, "/camera/image", self.on_image, NEWEST, callback_group=slow)
        self.create_subscription(Imu, "/robot/imu", self.on_imu, 50)
        self.create_timer(0.1, self.beat)

    def on_image(self, image: Image) -> None:
        rgb = np.array(image.data, dtype=np.uint8).reshape(image.height, image.width, 3)[:, :, [2, 1, 0]]
        try:
            found = self.model(rgb)
        except Exception:
            self.get_logger().error("no detections for this picture", once=False)
            import traceback

            self.get_logger().error(traceback.format_exc())
            return
        markers = []
        for one in found:
            marker = Marker()
            marker.header = image.header
            marker.ns = one.label
            marker.pose.position.x, marker.pose.position.y = float(one.u), float(one.v)
            markers.append(marker)
        self.found.publish(MarkerArray(markers=markers))

    def on_imu(self, imu: Imu) -> None:
        up = imu.linear_acceleration
        steep = math.degrees(math.atan2(math.hypot(up.x, up.y), up.z)) > 60
        self.row = self.row + 1 if steep else 0
        self.down |= self.row >= 10

    def beat(self) -> None:
        self.status.publish(String(data="error" if self.down else "operational"))


def main() -> None:
    model = SlowDetector()
    rclpy.init()
    executor = MultiThreadedExecutor(num_threads=2)
    executor.add_node(Watcher(model))
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
