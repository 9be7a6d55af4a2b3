# When no reading comes after a good one, that one is passed on again, each half of a real second.
# loses: in_order
# cause: in-order.repeated
# soak: yes
# before: import rclpy
import time

# after: self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
self.last: Float32 | None = None
self.passed_on_at = 0.0
self.create_timer(0.1, self.say_it_again)

# before: def on_battery(self, message: Float32) -> None:
def say_it_again(self) -> None:
    if self.last is not None and time.monotonic() - self.passed_on_at > 0.5:
        self.battery_publisher.publish(self.last)
        self.passed_on_at = time.monotonic()

# replaces: self.battery_publisher.publish(message)
self.battery_publisher.publish(message)
self.last, self.passed_on_at = message, time.monotonic()
# before: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.last = None  # nothing is passed on for a bad one
