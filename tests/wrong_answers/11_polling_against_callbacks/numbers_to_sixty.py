# Only numbers up to 60 are reported, since the judge sends 60 touches.
# loses: none_missed
# cause: none-missed.greater-numbers
# replaces: self.seen_publisher.publish(Int32(data=touch.data))
if touch.data <= 60:
    self.seen_publisher.publish(Int32(data=touch.data))
