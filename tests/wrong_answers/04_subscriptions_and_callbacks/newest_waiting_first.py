# Takes the newest of the readings that wait first.
# loses: in_order
# cause: in-order.other-order
# before: import rclpy
import queue
import threading
import time

# after: super().__init__("battery_monitor")
self.waiting: queue.LifoQueue[Float32] = queue.LifoQueue()

# after: self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
threading.Thread(target=self.send, daemon=True).start()

# before: def on_battery(self, message: Float32) -> None:
def send(self) -> None:
    while True:
        message = self.waiting.get()
        time.sleep(0.02)
        self.battery_publisher.publish(message)

# replaces: self.battery_publisher.publish(message)
self.waiting.put(message)
