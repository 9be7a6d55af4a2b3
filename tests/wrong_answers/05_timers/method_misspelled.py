# A letter is missing in the name of a method of Node.
# loses: program_runs
# cause: error.name-misspelled
# says: did you mean create_timer?
# replaces: self.create_timer(TILT_PERIOD_S, self.publish_tilt)
self.creat_timer(TILT_PERIOD_S, self.publish_tilt)
