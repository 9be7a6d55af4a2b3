# loses: twelve_values, joint_rate
# says: 3900 values
"""Right messages, and beside them 48 MB of arrays that are just short enough to be kept whole, on a topic of its own and
on that of the joints."""
import threading
import time

import rclpy.node
from std_msgs.msg import Float32MultiArray

_create = rclpy.node.Node.create_publisher


def create_publisher(self, kind, name, *arguments, **options):
    publisher = _create(self, kind, name, *arguments, **options)
    if name.endswith("joint_positions"):
        more = [publisher, _create(self, kind, "/robot/more", 10)]
        threading.Thread(target=flood, args=(more,), daemon=True).start()
    return publisher


def flood(publishers):
    message = Float32MultiArray(data=[number / 7 for number in range(3900)])
    while any(publisher.get_subscription_count() == 0 for publisher in publishers):
        time.sleep(0.05)
    for _ in range(1500):
        for publisher in publishers:
            publisher.publish(message)
        time.sleep(0.001)


rclpy.node.Node.create_publisher = create_publisher
@@GOOD@@
