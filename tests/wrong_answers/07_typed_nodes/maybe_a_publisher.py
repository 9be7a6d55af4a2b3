# The hint says that there may be no publisher.
# loses: clean, right_use
# skips: wrong_message_found, wrong_value_found
# cause: mypy.maybe-none
# says: "None" of "Sends[Float32] | None" has no attribute "publish"
# replaces: self.battery_publisher = make_publisher(self, Float32, "/robot/battery")
self.battery_publisher: Sends[Float32] | None = make_publisher(self, Float32, "/robot/battery")
