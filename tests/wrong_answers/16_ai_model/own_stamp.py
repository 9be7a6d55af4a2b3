# Stamps the detections with the clock of the node.
# loses: stamps_kept
# skips: fresh, right
# cause: stamps-kept.own-stamp
# replaces: self.detection_publisher.publish(to_markers(found, image.header))
self.detection_publisher.publish(to_markers(found, Header(stamp=self.get_clock().now().to_msg())))
