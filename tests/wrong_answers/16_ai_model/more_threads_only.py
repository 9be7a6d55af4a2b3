# Spins with several threads, but all callbacks are in one group.
# loses: heartbeat_kept, fall_reported
# cause: heartbeat-kept.waits-for-the-model
# on: right/groups_and_threads.py
# replaces: self.create_subscription(Image, "/camera/image", self.on_image, NEWEST, callback_group=slow)
self.create_subscription(Image, "/camera/image", self.on_image, NEWEST)
