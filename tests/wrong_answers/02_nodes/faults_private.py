# Each camera reports on a topic of its own.
# loses: shared_faults
# cause: shared-faults.other-name
# says: /robot/rear_camera/faults
# replaces: self.fault_publisher = self.create_publisher(String, "faults", 10)
self.fault_publisher = self.create_publisher(String, "~/faults", 10)
