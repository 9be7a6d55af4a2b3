# The subscription asks for messages that the publisher keeps for latecomers, and it keeps none.
# loses: plans_right, all_in_order
# cause: listens.other-qos
# says: DURABILITY
# after: from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile

# replaces: self.create_subscription(
# replaces:     Float32, "/robot/plan_request", self.on_request, 10, callback_group=planning
# replaces: )
kept = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
self.create_subscription(Float32, "/robot/plan_request", self.on_request, kept, callback_group=planning)
