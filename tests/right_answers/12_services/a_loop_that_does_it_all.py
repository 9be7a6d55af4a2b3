"""One loop beats, asks, spins for a moment, and looks at all open futures. No timer, no callback."""

import time

import rclpy
from rclpy.executors import ExternalShutdownException
from std_msgs.msg import String
from std_srvs.srv import Trigger


def main():
    rclpy.init()
    node = rclpy.create_node("health_monitor")
    heart = node.create_publisher(String, "/robot/heartbeat", 10)
    health = node.create_publisher(String, "/robot/health", 10)
    client = node.create_client(Trigger, "/robot/self_test")
    next_beat = next_ask = time.monotonic()
    calls = {}
    try:
        while rclpy.ok():
            rclpy.spin_once(node, timeout_sec=0.02)
            now = time.monotonic()
            if now >= next_beat:
                heart.publish(String(data="alive"))
                next_beat += 0.2
            if now >= next_ask:
                calls[client.call_async(Trigger.Request())] = now
                next_ask += 1.0
            for future, asked in list(calls.items()):
                if future.done():
                    health.publish(String(data="ok" if future.result().success else "faulty"))
                elif now > asked + 1.05:
                    client.remove_pending_request(future)
                    health.publish(String(data="no answer"))
                else:
                    continue
                del calls[future]
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    rclpy.try_shutdown()


if __name__ == "__main__":
    main()
