# Listens to an IMU that is not there.
# loses: status_topics
# skips: heartbeat_kept, fall_reported
# cause: listens.other-name
# replaces: self.create_subscription(Imu, "/robot/imu", self.on_imu, 10)
self.create_subscription(Imu, "/robot/imu_raw", self.on_imu, 10)
