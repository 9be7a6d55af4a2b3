# The heart beats twenty times.
# loses: heartbeat_count
# cause: silence.of-one
# says: the last of 20 messages
# says: while messages kept arriving on /robot/battery and /robot/tilt
# after: super().__init__("vital_signs")
self.beats_left = 20

# replaces: self.heartbeat_publisher.publish(String(data="alive"))
if self.beats_left > 0:
    self.heartbeat_publisher.publish(String(data="alive"))
self.beats_left -= 1
