# The publishers have other names than the ones that others use.
# loses: right_use, numbers_arrive
# skips: wrong_message_found, wrong_value_found
# cause: mypy-accepts.no-such-name
# says: battery_publisher
# replaces: self.battery_publisher = make_publisher(self, Float32, "/robot/battery")
# replaces: self.status_publisher = make_publisher(self, String, "/robot/status")
self.battery_pub = make_publisher(self, Float32, "/robot/battery")
self.status_pub = make_publisher(self, String, "/robot/status")

# replaces: self.battery_publisher.publish(Float32(data=float(level)))
self.battery_pub.publish(Float32(data=float(level)))

# replaces: self.status_publisher.publish(String(data=word))
self.status_pub.publish(String(data=word))
