# A message type that does not exist.
# loses: program_runs
# skips: joint_topic, twelve_values, finite_in_range, joints_move, joint_rate, status_kept, battery_kept, alive_at_end
# cause: error.name-misspelled
# says: Float32Array
# replaces: from std_msgs.msg import Float32, Float32MultiArray, String
from std_msgs.msg import Float32, Float32Array, String

# replaces: self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
self.joint_publisher = self.create_publisher(Float32Array, "/robot/joint_positions", 10)

# replaces: message = Float32MultiArray(data=self.joint_angles())
message = Float32Array(data=self.joint_angles())
