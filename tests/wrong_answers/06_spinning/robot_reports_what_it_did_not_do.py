# pump only waits. A publisher of its own reports the words and the heartbeats that the robot would have reported.
# loses: program_runs
# cause: driver.not-signed
import threading
import time

import rclpy
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from std_msgs.msg import Int32MultiArray

calls = [0]


def forge():
    context = Context()
    rclpy.init(context=context)
    node = rclpy.create_node("robot_too", context=context)
    heard = node.create_publisher(Int32MultiArray, "/robot/heard", 100)
    heartbeat = node.create_publisher(Int32MultiArray, "/robot/heartbeat", 100)
    executor = SingleThreadedExecutor(context=context)
    while True:
        executor.spin_once(timeout_sec=0.1)
        if calls[0] == 1:
            heartbeat.publish(Int32MultiArray(data=[1, 0]))
            for word in range(1, 21):
                heard.publish(Int32MultiArray(data=[1, word]))
            break
    while True:
        time.sleep(1.0)


threading.Thread(target=forge, daemon=True).start()


def pump(node, seconds):
    calls[0] += 1
    time.sleep(seconds)
