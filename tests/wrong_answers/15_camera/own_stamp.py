# Stamps the direction with the time of publishing.
# loses: stamps_kept
# skips: keeps_up, direction_right, light_changes, bgr_right, padding_right, no_ball_said
# cause: stamps-kept.own-stamp
# before: self.publisher.publish(answer)
answer.header.stamp = self.get_clock().now().to_msg()
