# Publishes the number, and not a message that holds it.
# loses: sends
# skips: floats_arrive, zero_arrives, numbers_arrive, no_number_refused, look_alikes_refused, not_finite_refused, no_invented_zero
# cause: number.no-message-made
# says: got <class 'float'>
# replaces: self.battery_publisher.publish(Float32(data=float(level)))
self.battery_publisher.publish(float(level))
