# Float64 instead of Float32.
# loses: tilt_topic
# skips: tilt_count
# cause: publishes.other-type
# says: Float64
# replaces: from std_msgs.msg import Float32, String
from std_msgs.msg import Float32, Float64, String

# replaces: self.tilt_publisher = self.create_publisher(Float32, "/robot/tilt", 10)
self.tilt_publisher = self.create_publisher(Float64, "/robot/tilt", 10)

# replaces: self.tilt_publisher.publish(Float32(data=0.1 * math.sin(math.pi * seconds)))
self.tilt_publisher.publish(Float64(data=0.05))
