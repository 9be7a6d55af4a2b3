# Publishes what was found in the picture before.
# loses: stamps_kept
# skips: fresh
# cause: stamps-kept.later-picture
# after: self.fallen = False
self.before = []
# replaces: self.detection_publisher.publish(to_markers(found, image.header))
if self.before:
    self.detection_publisher.publish(to_markers(self.before, image.header))
self.before = found
