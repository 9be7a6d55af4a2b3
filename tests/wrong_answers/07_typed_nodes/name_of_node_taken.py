# `publishers` is an attribute that Node has already.
# loses: program_runs
# cause: error.name-taken
# says: property 'publishers' of 'RobotReport' object has no setter
# after: self.level = 100.0
self.publishers: list[str] = []
