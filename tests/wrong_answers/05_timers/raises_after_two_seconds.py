# The tilt callback raises in its tenth call, and the whole program ends.
# loses: heartbeat_count, battery_count, alive_at_end
# cause: error.exception
# says: IndexError
# after: super().__init__("vital_signs")
self.readings = [0.1] * 9

# replaces: self.tilt_publisher.publish(Float32(data=0.1 * math.sin(math.pi * seconds)))
self.tilt_publisher.publish(Float32(data=self.readings.pop(0)))
