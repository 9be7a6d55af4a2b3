# The samples of the IMU are in the callback group of the pictures.
# loses: fall_reported
# cause: fall-reported.late, fall-reported.never
# on: right/groups_and_threads.py
# replaces: self.create_subscription(Imu, "/robot/imu", self.on_imu, 50)
self.create_subscription(Imu, "/robot/imu", self.on_imu, 50, callback_group=slow)
