# The rear camera takes seven pictures and no more.
# loses: rear_pictures
# cause: silence.of-one, rate.stops
# replaces: self.frames += 1
if self.get_name() == "rear_camera" and self.frames == 7:
    return
self.frames += 1
