# Asks for messages that were kept from before, which the sensor does not offer.
# loses: passes_on, alarms_come
# skips: in_order, bad_kept_back, one_alarm, no_false_alarm, own_robot_only
# cause: in-order.asks-for-old-messages
# after: from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile

# after: EMPTY, FULL = 0.0, 100.0
KEPT = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)

# replaces: self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)
self.create_subscription(Float32, "/robot/battery", self.on_battery, KEPT)
