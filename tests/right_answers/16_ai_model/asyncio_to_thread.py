"""An asyncio program: rclpy spins in a thread, the model runs in another, and a task goes from picture to picture."""

import asyncio
import math
import threading

import numpy as np
import rclpy
from rclpy.executors import ExternalShutdownException
from sensor_msgs.msg import Image, Imu
from std_msgs.msg import String
from visualization_msgs.msg import Marker, MarkerArray

from workbook.models.slow import SlowDetector


def spin(node):
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


def markers(header, found):
    message = MarkerArray()
    for number, one in enumerate(found):
        marker = Marker(header=header, ns=one.label, id=number)
        marker.pose.position.x, marker.pose.position.y = float(one.u), float(one.v)
        message.markers.append(marker)
    return message


async def main():
    rclpy.init()
    node = rclpy.create_node("watcher")
    model = SlowDetector()
    loop = asyncio.get_running_loop()
    arrived = asyncio.Event()
    newest = []
    state = {"row": 0, "fallen": False}

    def on_image(image):
        def keep():
            newest[:] = [image]
            arrived.set()

        loop.call_soon_threadsafe(keep)

    def on_imu(imu):
        a = imu.linear_acceleration
        tilted = math.degrees(math.acos(a.z / math.sqrt(a.x**2 + a.y**2 + a.z**2))) > 60.0
        state["row"] = state["row"] + 1 if tilted else 0
        if state["row"] >= 10:
            state["fallen"] = True

    found = node.create_publisher(MarkerArray, "/robot/detections", 10)
    status = node.create_publisher(String, "/robot/status", 10)
    node.create_subscription(Image, "/camera/image", on_image, 1)
    node.create_subscription(Imu, "/robot/imu", on_imu, 10)
    node.create_timer(
        0.1, lambda: status.publish(String(data="error" if state["fallen"] else "operational"))
    )
    thread = threading.Thread(target=spin, args=(node,), daemon=True)
    thread.start()
    while thread.is_alive():
        await arrived.wait()
        arrived.clear()
        image = newest.pop()
        pixels = np.frombuffer(image.data, np.uint8).reshape(image.height, image.width, 3)[:, :, ::-1]
        try:
            found.publish(markers(image.header, await asyncio.to_thread(model, pixels)))
        except RuntimeError as error:
            node.get_logger().error(repr(error))


if __name__ == "__main__":
    try:
        asyncio.run(main())
    except KeyboardInterrupt:
        rclpy.try_shutdown()
