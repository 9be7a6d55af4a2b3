# Publishes each direction twice.
# loses: stamps_kept
# cause: stamps-kept.repeated
# after: self.publisher.publish(answer)
self.publisher.publish(answer)
