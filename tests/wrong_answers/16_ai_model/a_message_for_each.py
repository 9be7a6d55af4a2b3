# Publishes a message for each detection.
# loses: stamps_kept
# skips: fresh, right
# cause: stamps-kept.one-for-each-detection
# replaces: self.detection_publisher.publish(to_markers(found, image.header))
for one in found:
    self.detection_publisher.publish(to_markers([one], image.header))
