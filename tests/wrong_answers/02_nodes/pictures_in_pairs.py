# Two pictures at once, and only once a second: right on average.
# loses: front_pictures, rear_pictures
# cause: rate.groups-with-silences
# replaces: self.create_timer(0.5, self.take_picture)
self.create_timer(1.0, self.take_picture)

# after: self.frame_publisher.publish(String(data=f"picture {self.frames}"))
self.frame_publisher.publish(String(data=f"picture {self.frames} again"))
