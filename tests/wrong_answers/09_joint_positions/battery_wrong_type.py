# The battery became a 64-bit float.
# loses: battery_kept
# cause: publishes.other-type
# says: Float64
# replaces: from std_msgs.msg import Float32, Float32MultiArray, String
from std_msgs.msg import Float32MultiArray, Float64, String

# replaces: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.battery_publisher = self.create_publisher(Float64, "/robot/battery", 10)

# replaces: self.battery_publisher.publish(Float32(data=self.battery_level))
self.battery_publisher.publish(Float64(data=self.battery_level))
