# Of the starter's three mistakes, one is fixed: the second shutdown.
# loses: battery_arrives, battery_rate
# cause: really-arrives.wrong-type
# says: 72 messages
# on: starter
# replaces: humanoid.destroy_node()
# replaces: rclpy.shutdown()
rclpy.try_shutdown()
