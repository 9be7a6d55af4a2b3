# Touches that come together are sorted before they are reported.
# loses: once_in_order
# cause: once-in-order.sorted
# also: quick
# before: import rclpy
import queue
import threading

# after: self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)
self.touches: queue.Queue[int] = queue.Queue()
threading.Thread(target=self.report, daemon=True).start()

# before: def on_touch(self, touch: Int32) -> None:
def report(self) -> None:
    while True:
        some = [self.touches.get()]
        try:
            while True:
                some.append(self.touches.get(timeout=0.005))
        except queue.Empty:
            pass
        for number in sorted(some):
            self.seen_publisher.publish(Int32(data=number))

# replaces: self.seen_publisher.publish(Int32(data=touch.data))
self.touches.put(touch.data)
