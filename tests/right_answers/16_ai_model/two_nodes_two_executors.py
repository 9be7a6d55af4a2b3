"""Two nodes: one sees, in an executor and a thread of its own; the other one watches over the robot."""

import math
import threading

import numpy as np
import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from sensor_msgs.msg import Image, Imu
from std_msgs.msg import String
from visualization_msgs.msg import Marker, MarkerArray

from workbook.models.slow import SlowDetector


class Eyes(Node):
    def __init__(self):
        super().__init__("eyes")
        self.model = SlowDetector()
        self.publisher = self.create_publisher(MarkerArray, "/robot/detections", 10)
        self.create_subscription(Image, "/camera/image", self.look, 1)

    def look(self, image):
        pixels = np.frombuffer(image.data, dtype=np.uint8).reshape(image.height, image.width, 3)
        try:
            detections = self.model(pixels[..., ::-1].copy())
        except RuntimeError as error:
            self.get_logger().error(f"{type(error).__name__}: {error}")
        else:
            self.publisher.publish(MarkerArray(markers=[self.marker(image, one) for one in detections]))

    def marker(self, image, one):
        marker = Marker()
        marker.header.stamp = image.header.stamp
        marker.header.frame_id = "camera"
        marker.ns = one.label
        marker.pose.position.x, marker.pose.position.y = float(one.u), float(one.v)
        return marker


class Balance(Node):
    def __init__(self):
        super().__init__("balance")
        self.last = []
        self.word = "operational"
        self.publisher = self.create_publisher(String, "/robot/status", 10)
        self.create_subscription(Imu, "/robot/imu", self.feel, 20)
        self.create_timer(0.1, self.beat)

    def feel(self, imu):
        a = imu.linear_acceleration
        angle = math.degrees(math.atan2(math.sqrt(a.x * a.x + a.y * a.y), a.z))
        self.last = [*self.last[-9:], angle]
        if len(self.last) == 10 and min(self.last) > 60:
            self.word = "error"

    def beat(self):
        self.publisher.publish(String(data=self.word))


def spin(node):
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    try:
        executor.spin()
    except ExternalShutdownException:
        pass


def main():
    rclpy.init()
    threading.Thread(target=spin, args=(Eyes(),), daemon=True).start()
    try:
        spin(Balance())
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
