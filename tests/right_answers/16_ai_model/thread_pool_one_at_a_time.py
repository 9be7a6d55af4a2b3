"""A pool of one thread; a picture that comes while the model is busy is kept, and replaced by the next one."""

import math
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import Image, Imu
from std_msgs.msg import String
from visualization_msgs.msg import Marker, MarkerArray

from workbook.models.slow import SlowDetector


class Watcher(Node):
    def __init__(self):
        super().__init__("watcher")
        self.pool = ThreadPoolExecutor(max_workers=1)
        self.model = self.pool.submit(SlowDetector)  # loads meanwhile
        self.lock = threading.Lock()
        self.busy, self.waiting = False, None
        self.count, self.fell = 0, False
        self.detections = self.create_publisher(MarkerArray, "/robot/detections", 10)
        self.status = self.create_publisher(String, "/robot/status", 10)
        self.create_subscription(Image, "/camera/image", self.on_image, 5)
        self.create_subscription(Imu, "/robot/imu", self.on_imu, 5)
        self.create_timer(0.1, self.on_timer)

    def on_image(self, image):
        with self.lock:
            if self.busy:
                self.waiting = image
                return
            self.busy = True
        self.pool.submit(self.work, image)

    def work(self, image):
        while image is not None:
            try:
                self.look(image)
            except Exception as error:
                self.get_logger().error(f"picture left out: {error}")
            with self.lock:
                image, self.waiting = self.waiting, None
                self.busy = image is not None

    def look(self, image):
        flat = np.frombuffer(image.data, np.uint8)
        blue, green, red = flat[0::3], flat[1::3], flat[2::3]
        rgb = np.stack([red, green, blue], axis=1).reshape(image.height, image.width, 3)
        found = self.model.result()(rgb)
        answer = MarkerArray()
        for one in found:
            marker = Marker(ns=one.label, header=image.header)
            marker.pose.position.x, marker.pose.position.y = float(one.u), float(one.v)
            answer.markers.append(marker)
        self.detections.publish(answer)

    def on_imu(self, imu):
        up = imu.linear_acceleration
        upright = up.z > 0 and math.hypot(up.x, up.y) / up.z <= math.sqrt(3)
        self.count = 0 if upright else self.count + 1
        self.fell = self.fell or self.count > 9

    def on_timer(self):
        self.status.publish(String(data=("operational", "error")[self.fell]))


def main():
    rclpy.init()
    try:
        rclpy.spin(Watcher())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
