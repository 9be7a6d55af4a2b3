# Publishes when it begins anew, and then goes on to the line that publishes every answer.
# loses: every_one_answered
# cause: every-one-answered.repeated-at-restart
# after: angles = np.array(message.position)
if (message.header.stamp.sec, message.header.stamp.nanosec) < self.last_stamp:
    self.publisher.publish(message)
