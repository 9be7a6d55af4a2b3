# Listens to a private name, which begins with that of the node.
# loses: hears_heartbeat
# skips: alarm_raised, no_false_alarm, alarm_falls
# cause: listens.private-name
# says: /dashboard/heartbeat
# replaces: self.create_subscription(String, "/robot/heartbeat", self.on_beat, BEAT_QOS)
self.create_subscription(String, "~/heartbeat", self.on_beat, BEAT_QOS)
