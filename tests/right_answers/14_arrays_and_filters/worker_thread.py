"""The callback hands each message to a thread, which filters and publishes it."""

import queue
import threading
from collections import deque

import numpy as np
import rclpy
from rclpy.executors import ExternalShutdownException
from sensor_msgs.msg import JointState


def work(inbox, publisher):
    window, last = deque(maxlen=6), None
    while (message := inbox.get()) is not None:
        stamp = (message.header.stamp.sec, message.header.stamp.nanosec)
        if last is not None and stamp < last:
            window.clear()
        last = stamp
        window.append(np.array(message.position))
        answer = JointState()
        answer.header = message.header
        answer.name = message.name
        answer.position = np.nanmean(np.array(window), axis=0).tolist()
        publisher.publish(answer)


def main():
    rclpy.init()
    node = rclpy.create_node("worker")
    inbox = queue.Queue()
    publisher = node.create_publisher(JointState, "/robot/joint_states", 50)
    node.create_subscription(JointState, "/encoders/joint_states", inbox.put, 50)
    thread = threading.Thread(target=work, args=(inbox, publisher))
    thread.start()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        inbox.put(None)
        thread.join()


if __name__ == "__main__":
    main()
