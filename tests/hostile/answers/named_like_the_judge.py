# loses: joint_topic
"""Publishes a topic with another type as well, by a node that is called like the one that it finds in the graph."""
import time

import rclpy
from std_msgs.msg import String

context = rclpy.context.Context()  # of its own: one participant cannot have two types on a topic
rclpy.init(context=context)
spy = rclpy.create_node("spy", context=context, start_parameter_services=False)
others = []
while not others:
    time.sleep(0.05)
    others = [one for one in spy.get_node_names_and_namespaces() if one[0] != "spy"]
name, namespace = others[0]
beside = rclpy.create_node(name, context=context, namespace=namespace, start_parameter_services=False)
time.sleep(1.0)  # until the name is known
publisher = beside.create_publisher(String, "/robot/joint_positions", 10)
@@GOOD@@
