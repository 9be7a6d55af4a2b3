# Stamps the answer with the time of publishing.
# loses: labels_kept
# cause: labels-kept.own-stamp
# before: self.publisher.publish(message)
message.header.stamp = self.get_clock().now().to_msg()
