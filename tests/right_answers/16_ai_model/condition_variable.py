"""A worker thread waits for a condition; the newest picture is an attribute. The status thread is a timer."""

import math
import threading

import cv2
import numpy as np
import rclpy
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image, Imu
from std_msgs.msg import String
from visualization_msgs.msg import Marker, MarkerArray

from workbook.models.slow import SlowDetector


class Watcher(Node):
    def __init__(self):
        super().__init__("watcher")
        self.detector = SlowDetector()
        self.condition = threading.Condition()
        self.image = None
        self.in_a_row = 0
        self.status = "operational"
        self.out = self.create_publisher(MarkerArray, "/robot/detections", 1)
        self.state = self.create_publisher(String, "/robot/status", 1)
        self.create_subscription(Image, "/camera/image", self.seen, qos_profile_sensor_data)
        self.create_subscription(Imu, "/robot/imu", self.felt, qos_profile_sensor_data)
        self.create_timer(0.1, lambda: self.state.publish(String(data=self.status)))
        threading.Thread(target=self.work, daemon=True).start()

    def seen(self, image):
        with self.condition:
            self.image = image
            self.condition.notify()

    def felt(self, imu):
        a = imu.linear_acceleration
        length = math.sqrt(a.x**2 + a.y**2 + a.z**2)
        if a.z < length * math.cos(math.radians(60)):
            self.in_a_row += 1
        else:
            self.in_a_row = 0
        if self.in_a_row == 10:
            self.status = "error"

    def work(self):
        while True:
            with self.condition:
                self.condition.wait_for(lambda: self.image is not None)
                image, self.image = self.image, None
            try:
                bgr = np.frombuffer(image.data, np.uint8).reshape((image.height, image.width, 3))
                self.publish(image.header, self.detector(cv2.cvtColor(bgr, cv2.COLOR_BGR2RGB)))
            except RuntimeError as problem:
                self.get_logger().warning(str(problem))

    def publish(self, header, found):
        message = MarkerArray()
        for each in found:
            marker = Marker(header=header, ns=each.label)
            marker.pose.position.x = float(each.u)
            marker.pose.position.y = float(each.v)
            message.markers.append(marker)
        self.out.publish(message)
