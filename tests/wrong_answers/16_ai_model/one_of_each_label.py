# Keeps the detections in a dictionary by label: of two bricks, one gets lost.
# loses: right
# cause: right.some-missing
# replaces: self.detection_publisher.publish(to_markers(found, image.header))
by_label = {one.label: one for one in found}
self.detection_publisher.publish(to_markers(list(by_label.values()), image.header))
