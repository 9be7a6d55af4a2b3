"""The model lives in a process of its own; the node hands over the newest picture when it has answered the last."""

import math
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import Image, Imu
from std_msgs.msg import String
from visualization_msgs.msg import Marker, MarkerArray

MODEL = None


def load():
    global MODEL
    from workbook.models.slow import SlowDetector

    MODEL = SlowDetector()


def ready():
    return MODEL is not None


def look(data, height, width):
    bgr = np.frombuffer(data, np.uint8).reshape(height, width, 3)
    return [(one.label, float(one.u), float(one.v)) for one in MODEL(np.ascontiguousarray(bgr[..., ::-1]))]


class Watcher(Node):
    def __init__(self, pool):
        super().__init__("watcher")
        self.pool, self.open, self.image = pool, None, None
        self.row, self.fallen = 0, False
        self.found = self.create_publisher(MarkerArray, "/robot/detections", 10)
        self.status = self.create_publisher(String, "/robot/status", 10)
        self.create_subscription(Image, "/camera/image", self.on_image, 1)
        self.create_subscription(Imu, "/robot/imu", self.on_imu, 100)
        self.create_timer(0.1, self.beat)
        self.create_timer(0.01, self.collect)

    def on_image(self, image):
        self.image = image
        if self.open is None:
            self.hand_over()

    def hand_over(self):
        image, self.image = self.image, None
        self.open = image.header, self.pool.submit(look, bytes(image.data), image.height, image.width)

    def collect(self):
        if self.open is None or not self.open[1].done():
            return
        header, future = self.open
        self.open = None
        try:
            found = future.result()
        except RuntimeError as error:
            self.get_logger().error(f"{error}")
        else:
            message = MarkerArray()
            for label, u, v in found:
                marker = Marker(header=header, ns=label)
                marker.pose.position.x, marker.pose.position.y = u, v
                message.markers.append(marker)
            self.found.publish(message)
        if self.image is not None:
            self.hand_over()

    def on_imu(self, imu):
        a = imu.linear_acceleration
        self.row = self.row + 1 if math.hypot(a.x, a.y) > a.z * math.tan(math.pi / 3) else 0
        if self.row >= 10:
            self.fallen = True

    def beat(self):
        self.status.publish(String(data="error" if self.fallen else "operational"))


def main():
    pool = ProcessPoolExecutor(1, initializer=load)
    assert pool.submit(ready).result()
    rclpy.init()
    try:
        rclpy.spin(Watcher(pool))
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
        pool.shutdown(wait=False, cancel_futures=True)


if __name__ == "__main__":
    main()
