# A second node, of another name.
# loses: guard_on_the_graph
# cause: guard-on-the-graph.another-node
# says: /helper
# after: guard = NightGuard()
helper = rclpy.create_node("helper")
