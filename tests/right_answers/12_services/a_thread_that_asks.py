"""The main thread spins; a thread of its own asks, waits, and tells."""

import threading
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import String
from std_srvs.srv import Trigger

rclpy.init()
node = rclpy.create_node("health_monitor")
heartbeat = node.create_publisher(String, "/robot/heartbeat", 10)
health = node.create_publisher(String, "/robot/health", 10)
client = node.create_client(Trigger, "/robot/self_test")
node.create_timer(0.2, lambda: heartbeat.publish(String(data="alive")))
closing = threading.Event()


def ask_again_and_again():
    due = time.monotonic() + 0.5
    while not closing.wait(max(0.0, due - time.monotonic())):
        due += 1.0
        answer = client.call(Trigger.Request(), timeout_sec=0.97)
        if closing.is_set():
            return
        if answer is None:
            health.publish(String(data="no answer"))
        else:
            health.publish(String(data="ok" if answer.success else "faulty"))


asker = threading.Thread(target=ask_again_and_again)
asker.start()
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException):
    pass
closing.set()
asker.join()
rclpy.try_shutdown()
