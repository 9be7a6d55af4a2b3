# The header is an attribute, which the next picture overwrites while the model is busy.
# loses: stamps_kept
# cause: stamps-kept.later-picture
# before: self.newest.put_nowait(image)
self.header = image.header
# replaces: self.detection_publisher.publish(to_markers(found, image.header))
self.detection_publisher.publish(to_markers(found, self.header))
