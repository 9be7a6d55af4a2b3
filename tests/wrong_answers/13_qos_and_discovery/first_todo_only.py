# The starter with its first TODO done.
# loses: hears_heartbeat, alarm_topic
# skips: alarm_kept, alarm_raised, no_false_alarm, alarm_falls
# cause: listens.nothing
# on: starter
# after: from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile

# replaces: self.create_subscription(String, "/robot/status", self.on_status, 10)
state_qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
self.create_subscription(String, "/robot/status", self.on_status, state_qos)
