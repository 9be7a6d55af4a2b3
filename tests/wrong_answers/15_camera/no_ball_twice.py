# Publishes that there is no ball, and then goes on and publishes once more.
# loses: stamps_kept
# cause: stamps-kept.no-ball-repeated
# replaces: if ball is not None:
if ball is None:
    self.publisher.publish(answer)
else:
