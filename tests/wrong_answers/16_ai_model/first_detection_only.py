# Publishes the surest detection, and none of the others.
# loses: right
# cause: right.only-one
# replaces: self.detection_publisher.publish(to_markers(found, image.header))
self.detection_publisher.publish(to_markers(found[:1], image.header))
