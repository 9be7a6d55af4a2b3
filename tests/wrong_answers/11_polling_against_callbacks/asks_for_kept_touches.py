# The subscription asks for messages that the skin keeps for latecomers, and it keeps none.
# loses: none_missed, once_in_order, quick
# cause: listens.other-qos
# says: DURABILITY
# after: from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile

# replaces: self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)
kept = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
self.create_subscription(Int32, "/robot/touch", self.on_touch, kept)
