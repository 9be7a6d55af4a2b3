# The heartbeat is a Bool.
# loses: heartbeat_topic
# skips: heartbeat_share, heartbeat_gap
# cause: publishes.other-type
# replaces: from std_msgs.msg import Float32, String
from std_msgs.msg import Bool, Float32

# replaces: self.heartbeat_publisher = self.create_publisher(String, "/robot/heartbeat", 10)
self.heartbeat_publisher = self.create_publisher(Bool, "/robot/heartbeat", 10)

# replaces: self.heartbeat_publisher.publish(String(data="alive"))
self.heartbeat_publisher.publish(Bool(data=True))
