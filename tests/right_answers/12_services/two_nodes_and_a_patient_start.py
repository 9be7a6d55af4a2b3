"""A heart and a tester as two nodes in one executor. Waits for the service first; a one-shot timer gives up."""

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger


class Heart(Node):
    def __init__(self):
        super().__init__("heart")
        pub = self.create_publisher(String, "/robot/heartbeat", 10)
        self.create_timer(0.2, lambda: pub.publish(String(data="alive")))


class Tester(Node):
    def __init__(self):
        super().__init__("tester")
        self.pub = self.create_publisher(String, "/robot/health", 10)
        self.client = self.create_client(Trigger, "/robot/self_test")
        while not self.client.wait_for_service(timeout_sec=1.0):
            self.get_logger().info("waiting for the self-test")
        self.patience = None
        self.number = 0
        self.create_timer(1.0, self.ask)

    def ask(self):
        self.number += 1
        number = self.number
        future = self.client.call_async(Trigger.Request())
        patience = self.create_timer(0.93, lambda: future.cancel())

        def over(future):
            self.destroy_timer(patience)
            if future.cancelled():
                word = "no answer"
            else:
                word = "ok" if future.result().success else "faulty"
            self.get_logger().info(f"call {number}: {word}")
            self.pub.publish(String(data=word))

        future.add_done_callback(over)


def main():
    rclpy.init()
    executor = SingleThreadedExecutor()
    for node in (Heart(), Tester()):
        executor.add_node(node)
    try:
        executor.spin()
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
