# Adds what was found in the picture before.
# loses: right
# cause: right.some-extra
# after: self.fallen = False
self.before = []
# replaces: self.detection_publisher.publish(to_markers(found, image.header))
self.detection_publisher.publish(to_markers([*found, *self.before], image.header))
self.before = found
