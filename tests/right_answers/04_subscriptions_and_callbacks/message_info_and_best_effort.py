"""Listens as one listens to sensors, and says in the alarm when the reading was sent."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from std_msgs.msg import Float32, String


class Monitor(Node):
    def __init__(self):
        super().__init__("monitor")
        self.last_good = None
        self.pub_battery = self.create_publisher(Float32, "/monitor/battery", 10)
        self.pub_alarm = self.create_publisher(String, "/monitor/alarm", 10)
        self.subscription = self.create_subscription(
            Float32, "/robot/battery", self.callback, qos_profile_sensor_data
        )

    def callback(self, msg, info):
        if not 0.0 <= msg.data <= 100.0:
            sent_s = info["source_timestamp"] / 1e9
            text = f"bad reading {msg.data}, sent at {sent_s:.3f} s; the last good one was {self.last_good}"
            self.pub_alarm.publish(String(data=text))
        else:
            self.last_good = msg.data
            self.pub_battery.publish(Float32(data=self.last_good))


def main():
    rclpy.init()
    node = Monitor()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == "__main__":
    main()
