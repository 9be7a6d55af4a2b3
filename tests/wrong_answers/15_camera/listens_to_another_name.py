# Listens to /camera/image_raw.
# loses: topics
# cause: listens.other-name
# replaces: self.create_subscription(Image, "/camera/image", self.on_image, qos_profile_sensor_data)
self.create_subscription(Image, "/camera/image_raw", self.on_image, qos_profile_sensor_data)
