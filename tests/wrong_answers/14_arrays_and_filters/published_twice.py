# Publishes each answer twice, so that it surely arrives.
# loses: every_one_answered
# cause: every-one-answered.repeated
# after: self.publisher.publish(message)
self.publisher.publish(message)
