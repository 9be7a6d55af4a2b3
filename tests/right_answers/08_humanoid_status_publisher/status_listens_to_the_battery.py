"""Two nodes in two threads: the status hears the charge on the topic, as any other node would."""

import random
from threading import Thread

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Float32, String


class Battery(Node):
    def __init__(self):
        super().__init__("battery")
        self.level = 100.0
        self.publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.create_timer(2.0, self.drain)

    def drain(self):
        self.level = max(0.0, self.level - random.uniform(7.0, 10.0))
        self.publisher.publish(Float32(data=float(round(self.level))))


class Status(Node):
    def __init__(self):
        super().__init__("status")
        self.charge = 100.0
        self.create_subscription(Float32, "/robot/battery", self.hear, 10)
        self.publisher = self.create_publisher(String, "/robot/status", 10)
        self.create_timer(1.0, self.tell)

    def hear(self, message):
        self.charge = message.data

    def tell(self):
        self.publisher.publish(String(data="error" if self.charge <= 0.0 else "operational"))


def spin(executor):
    try:
        executor.spin()
    except ExternalShutdownException:
        pass


def main():
    rclpy.init()
    executors = [SingleThreadedExecutor(), SingleThreadedExecutor()]
    for executor, kind in zip(executors, (Battery, Status)):
        executor.add_node(kind())
    thread = Thread(target=spin, args=(executors[0],))
    thread.start()
    try:
        spin(executors[1])
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()
        thread.join()


if __name__ == "__main__":
    main()
