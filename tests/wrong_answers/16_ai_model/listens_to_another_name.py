# Listens to a camera that is not there.
# loses: camera_topics
# skips: detections_come, stamps_kept, fresh, right, survives
# cause: listens.other-name
# replaces: self.create_subscription(Image, "/camera/image", self.on_image, 1)
self.create_subscription(Image, "/camera/image_raw", self.on_image, 1)
