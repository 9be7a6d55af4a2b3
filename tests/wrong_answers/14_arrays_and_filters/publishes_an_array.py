# Publishes the angles alone, as an array without names.
# loses: output_topic
# skips: answers_come, labels_kept, every_one_answered, filters, noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: publishes.other-type
# replaces: from sensor_msgs.msg import JointState
from sensor_msgs.msg import JointState
from std_msgs.msg import Float32MultiArray

# replaces: self.publisher = self.create_publisher(JointState, "/robot/joint_states", 50)
self.publisher = self.create_publisher(Float32MultiArray, "/robot/joint_states", 50)

# replaces: self.publisher.publish(message)
self.publisher.publish(Float32MultiArray(data=message.position))
