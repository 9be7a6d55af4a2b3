"""A thread that looks at the pictures, while the callback only puts them into a queue."""

import math
import queue
import threading

import cv2
import numpy as np
import rclpy
from geometry_msgs.msg import Vector3Stamped
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import Image


CODES = {"rgb8": cv2.COLOR_RGB2HSV_FULL, "bgr8": cv2.COLOR_BGR2HSV_FULL}


def find(pixels, code):
    cv2.setNumThreads(1)
    hsv = cv2.cvtColor(np.ascontiguousarray(pixels), code)
    mask = cv2.morphologyEx(cv2.inRange(hsv, (6, 130, 30), (32, 255, 255)), cv2.MORPH_OPEN, np.ones((2, 2), np.uint8))
    for outline in cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)[0]:
        (column, row), radius = cv2.minEnclosingCircle(outline)
        if radius > 3 and cv2.contourArea(outline) > 0.6 * math.pi * radius**2:
            return column, row
    return None


class Tracker(Node):
    def __init__(self):
        super().__init__("tracker")
        self.publisher = self.create_publisher(Vector3Stamped, "/robot/ball_direction", 10)
        self.create_subscription(Image, "/camera/image", self.pictures.put, 10)

    pictures = queue.SimpleQueue()

    def look_at_all(self):
        while True:
            image = self.pictures.get()
            if image is None:
                return
            if image.encoding not in CODES:
                print("cannot read", image.encoding, flush=True)
                continue
            data = np.array(image.data, dtype=np.uint8).reshape(image.height, image.step)
            pixels = np.lib.stride_tricks.as_strided(
                data, (image.height, image.width, 3), (image.step, 3, 1), writeable=False
            )
            answer = Vector3Stamped(header=image.header)
            ball = find(pixels, CODES[image.encoding])
            if ball is not None:
                ray = np.array([(ball[0] - 79.5) / 140.0, (ball[1] - 59.5) / 140.0, 1.0])
                ray /= np.linalg.norm(ray)
                answer.vector.x, answer.vector.y, answer.vector.z = map(float, ray)
            self.publisher.publish(answer)


def main():
    rclpy.init()
    node = Tracker()
    worker = threading.Thread(target=node.look_at_all)
    worker.start()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.pictures.put(None)
        worker.join()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
