# Leaves out whatever is no ball or brick.
# loses: right
# cause: right.some-missing
# replaces: self.detection_publisher.publish(to_markers(found, image.header))
some = [one for one in found if one.label in ("ball", "brick")]
self.detection_publisher.publish(to_markers(some or found[:1], image.header))
