# Publishes each direction twice.
# loses: stamps_kept
# skips: keeps_up, direction_right, light_changes, bgr_right, padding_right, no_ball_said
# cause: stamps-kept.repeated
# after: self.publisher.publish(answer)
self.publisher.publish(answer)
