# The alarm is True while the heart beats.
# loses: alarm_raised
# skips: alarm_falls
# cause: alarm-raised.inverted
# replaces: self.alarm_publisher.publish(Bool(data=alarm))
self.alarm_publisher.publish(Bool(data=not alarm))
