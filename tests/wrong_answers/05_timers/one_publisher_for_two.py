# Battery and tilt keep their publishers under one name, so what the battery reports goes out as a tilt.
# loses: battery_count, tilt_count
# cause: no-message.silent-beside-others
# replaces: self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)
self.publisher = self.create_publisher(Float32, "/robot/battery", 10)

# replaces: self.tilt_publisher = self.create_publisher(Float32, "/robot/tilt", 10)
self.publisher = self.create_publisher(Float32, "/robot/tilt", 10)

# replaces: self.battery_publisher.publish(Float32(data=self.battery_level))
self.publisher.publish(Float32(data=self.battery_level))

# replaces: self.tilt_publisher.publish(Float32(data=0.1 * math.sin(math.pi * seconds)))
self.publisher.publish(Float32(data=0.1 * math.sin(math.pi * seconds)))
