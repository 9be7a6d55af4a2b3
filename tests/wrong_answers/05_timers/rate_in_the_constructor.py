# Waits for a rate before anything spins.
# loses: program_runs
# cause: spin.rate-without-a-spin
# replaces: self.heartbeat_publisher = self.create_publisher(String, "/robot/heartbeat", 10)
rate = self.create_rate(1.0)
rate.sleep()
self.heartbeat_publisher = self.create_publisher(String, "/robot/heartbeat", 10)
