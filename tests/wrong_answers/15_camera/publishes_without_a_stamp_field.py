# Publishes a Vector3, which has no header.
# loses: topics
# cause: publishes.other-type
# replaces: from geometry_msgs.msg import Vector3Stamped
from geometry_msgs.msg import Vector3, Vector3Stamped
# replaces: self.publisher = self.create_publisher(Vector3Stamped, "/robot/ball_direction", 10)
self.publisher = self.create_publisher(Vector3, "/robot/ball_direction", 10)
# replaces: self.publisher.publish(answer)
self.publisher.publish(answer.vector)
