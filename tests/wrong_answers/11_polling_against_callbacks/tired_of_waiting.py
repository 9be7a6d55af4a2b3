# The thread that reports ends when no touch comes for two seconds.
# loses: none_missed
# cause: none-missed.stops
# before: import rclpy
import queue
import threading

# after: self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)
self.touches: queue.Queue[int] = queue.Queue()
threading.Thread(target=self.report, daemon=True).start()

# before: def on_touch(self, touch: Int32) -> None:
def report(self) -> None:
    self.seen_publisher.publish(Int32(data=self.touches.get()))
    while True:
        self.seen_publisher.publish(Int32(data=self.touches.get(timeout=2.0)))

# replaces: self.seen_publisher.publish(Int32(data=touch.data))
self.touches.put(touch.data)
