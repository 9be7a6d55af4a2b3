# Another type than the robot sends.
# loses: hears_heartbeat
# skips: alarm_raised, no_false_alarm, alarm_falls
# cause: listens.other-type
# says: Bool
# replaces: self.create_subscription(String, "/robot/heartbeat", self.on_beat, BEAT_QOS)
self.create_subscription(Bool, "/robot/heartbeat", self.on_beat, BEAT_QOS)
