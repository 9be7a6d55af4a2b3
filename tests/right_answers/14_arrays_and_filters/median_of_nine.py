"""An async callback, best effort, spin_once: the median of the last nine angles of each joint."""

import statistics
from collections import deque

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import JointState

QOS = QoSProfile(depth=50, reliability=ReliabilityPolicy.BEST_EFFORT)


class MedianFilter(Node):
    """The median shrugs off a NaN by itself, as long as NaNs are left out of it."""

    def __init__(self):
        super().__init__("median_filter")
        self.columns = []
        self.stamp = None
        self.pub = self.create_publisher(JointState, "/robot/joint_states", 10)
        self.create_subscription(JointState, "/encoders/joint_states", self.on_joints, QOS)

    async def on_joints(self, message):
        stamp = message.header.stamp
        now = stamp.sec + 1e-9 * stamp.nanosec
        if self.stamp is None or self.stamp > now:
            self.columns = [deque(maxlen=9) for _ in message.position]
        self.stamp = now
        for column, angle in zip(self.columns, message.position):
            column.append(angle)
        message.position = [statistics.median(a for a in column if a == a) for column in self.columns]
        self.pub.publish(message)


def main():
    rclpy.init()
    node = MedianFilter()
    try:
        while rclpy.ok():
            rclpy.spin_once(node, timeout_sec=1.0)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
