# Publishes a nan in place of each bad reading.
# loses: bad_kept_back
# cause: bad-kept-back.nan-instead
# after: self.alarm_publisher.publish(String(data=f"bad reading: {message.data}"))
self.battery_publisher.publish(Float32(data=float("nan")))
