# Makes the message, and does not publish it.
# loses: sends
# skips: floats_arrive, zero_arrives, numbers_arrive, no_number_refused, look_alikes_refused, not_finite_refused, no_invented_zero
# cause: number.not-sent
# says: published: nothing
# replaces: self.battery_publisher.publish(Float32(data=float(level)))
message = Float32()
message.data = float(level)
