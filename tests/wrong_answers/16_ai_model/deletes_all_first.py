# Begins each message with a marker that deletes all earlier ones.
# loses: right
# cause: right.no-toy
# replaces: self.detection_publisher.publish(to_markers(found, image.header))
message = to_markers(found, image.header)
message.markers.insert(0, Marker(header=image.header, action=Marker.DELETEALL))
self.detection_publisher.publish(message)
