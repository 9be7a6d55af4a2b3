# A quarter too fast.
# loses: front_pictures, rear_pictures
# cause: rate.too-fast
# says: 2.5 Hz
# replaces: self.create_timer(0.5, self.take_picture)
self.create_timer(0.4, self.take_picture)
