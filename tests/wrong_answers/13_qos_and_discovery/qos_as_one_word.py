# A word takes the place of the whole profile.
# loses: program_runs
# cause: error.qos-not-a-profile
# replaces: self.create_subscription(String, "/robot/heartbeat", self.on_beat, BEAT_QOS)
self.create_subscription(String, "/robot/heartbeat", self.on_beat, "sensor_data")
