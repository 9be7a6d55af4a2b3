# Publishes its last answer again for a message with a NaN, with the stamp that it had.
# loses: every_one_answered
# cause: every-one-answered.repeated-for-nan
# after: angles = np.array(message.position)
if np.isnan(angles).any():
    self.publisher.publish(self.last_answer)
    return
# replaces: self.publisher.publish(message)
self.last_answer = message
self.publisher.publish(message)
