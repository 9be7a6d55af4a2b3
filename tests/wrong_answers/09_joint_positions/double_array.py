# The sister type with 64-bit floats.
# loses: joint_topic
# skips: twelve_values, finite_in_range, joints_move, joint_rate
# cause: publishes.other-type
# says: Float64MultiArray
# replaces: from std_msgs.msg import Float32, Float32MultiArray, String
from std_msgs.msg import Float32, Float64MultiArray, String

# replaces: self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
self.joint_publisher = self.create_publisher(Float64MultiArray, "/robot/joint_positions", 10)

# replaces: message = Float32MultiArray(data=self.joint_angles())
message = Float64MultiArray(data=self.joint_angles())
