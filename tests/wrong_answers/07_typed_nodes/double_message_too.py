# The publisher of the battery also takes a Float64, by its hint.
# loses: wrong_message_found
# cause: wrong-message-found.publisher-takes-any
# replaces: from std_msgs.msg import Float32, String
from std_msgs.msg import Float32, Float64, String

# replaces: self.battery_publisher = make_publisher(self, Float32, "/robot/battery")
self.battery_publisher: Sends[Float32 | Float64] = self.create_publisher(Float32, "/robot/battery", 10)
