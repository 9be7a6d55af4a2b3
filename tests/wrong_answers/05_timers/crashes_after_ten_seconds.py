# A list runs out in the fifth battery report.
# loses: alive_at_end
# cause: error.exception
# says: IndexError
# after: super().__init__("vital_signs")
self.marks = [1, 2, 3, 4]

# before: self.battery_publisher.publish(Float32(data=self.battery_level))
self.marks.pop()
