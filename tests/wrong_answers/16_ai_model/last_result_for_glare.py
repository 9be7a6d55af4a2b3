# Publishes the last detections again when the model raises.
# loses: survives
# cause: survives.answered
# after: self.fallen = False
self.last = []
# replaces:     self.get_logger().error(f"The model gave up: {error}")
# replaces:     return
    self.get_logger().error(f"The model gave up: {error}")
    found = self.last
# before: self.detection_publisher.publish(to_markers(found, image.header))
self.last = found
