# Nothing calls take_picture any more.
# loses: front_pictures, rear_pictures
# cause: pictures.never-taken
# replaces: self.create_timer(0.5, self.take_picture)
