# Logs the result and publishes nothing.
# loses: health_topic
# skips: results_told, unanswered_told
# cause: publishes.nothing
# says: /robot/health
# replaces: self.health_publisher = self.create_publisher(String, "/robot/health", 10)

# replaces: self.health_publisher.publish(String(data=health))
self.get_logger().info(f"health: {health}")
