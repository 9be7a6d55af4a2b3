# A misspelled name in the callback of the battery, which is called for the first time after two seconds.
# loses: heartbeat_count, battery_count, alive_at_end
# cause: error.name-misspelled
# says: did you mean battery_publisher?
# replaces: self.battery_publisher.publish(Float32(data=self.battery_level))
self.battery_publsher.publish(Float32(data=self.battery_level))
