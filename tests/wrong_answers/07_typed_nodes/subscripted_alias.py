# An alias of a generic Publisher, which newer versions of rclpy have: Python fails where a hint would not.
# loses: program_runs
# cause: error.generic-publisher
# after: from rclpy.node import Node
from rclpy.publisher import Publisher

# after: Status = Literal["operational", "error"]
BatteryPublisher = Publisher[Float32]
StatusPublisher = Publisher[String]

# replaces: self.battery_publisher = make_publisher(self, Float32, "/robot/battery")
# replaces: self.status_publisher = make_publisher(self, String, "/robot/status")
self.battery_publisher: BatteryPublisher = self.create_publisher(Float32, "/robot/battery", 10)
self.status_publisher: StatusPublisher = self.create_publisher(String, "/robot/status", 10)
