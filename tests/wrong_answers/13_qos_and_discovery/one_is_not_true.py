# An int in a bool field is sent as False.
# loses: alarm_raised
# skips: alarm_falls
# cause: alarm-raised.false-instead
# replaces: self.alarm_publisher.publish(Bool(data=alarm))
self.alarm_publisher.publish(Bool(data=int(alarm)))
