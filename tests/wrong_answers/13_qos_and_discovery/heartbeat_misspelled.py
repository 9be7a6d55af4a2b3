# A character too many in the name of the topic.
# loses: hears_heartbeat
# skips: alarm_raised, no_false_alarm, alarm_falls
# cause: listens.other-name
# says: /robot/heart_beat
# replaces: self.create_subscription(String, "/robot/heartbeat", self.on_beat, BEAT_QOS)
self.create_subscription(String, "/robot/heart_beat", self.on_beat, BEAT_QOS)
