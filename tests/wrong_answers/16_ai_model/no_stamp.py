# Leaves the headers empty.
# loses: stamps_kept
# skips: fresh, right
# cause: stamps-kept.no-stamp
# replaces: self.detection_publisher.publish(to_markers(found, image.header))
self.detection_publisher.publish(to_markers(found, Header()))
