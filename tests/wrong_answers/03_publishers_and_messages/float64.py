# Sends 64 bits where 32 were agreed on.
# loses: battery_topic
# skips: sends, floats_arrive, zero_arrives, numbers_arrive, no_number_refused, look_alikes_refused, not_finite_refused, no_invented_zero
# cause: publishes.other-type
# says: Float64
# replaces: from std_msgs.msg import Float32
from std_msgs.msg import Float64

# replaces: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.battery_publisher = self.create_publisher(Float64, "/robot/battery", 10)

# replaces: self.battery_publisher.publish(Float32(data=float(level)))
self.battery_publisher.publish(Float64(data=float(level)))
