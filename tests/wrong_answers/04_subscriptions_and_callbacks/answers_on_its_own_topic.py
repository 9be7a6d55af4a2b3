# Publishes where it listens, and so hears itself, again and again.
# loses: battery_topic
# skips: passes_on, in_order, bad_kept_back, own_robot_only
# cause: battery-topic.publishes-where-it-listens
# before: import rclpy
import time

# replaces: self.battery_publisher = self.create_publisher(Float32, "/monitor/battery", 10)
# replaces: self.alarm_publisher = self.create_publisher(String, "/monitor/alarm", 10)
# replaces: self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 1000)
self.alarm_publisher = self.create_publisher(String, "/monitor/alarm", 1000)
self.create_subscription(Float32, "/robot/battery", self.on_battery, 1000)

# before: self.battery_publisher.publish(message)
time.sleep(0.005)
