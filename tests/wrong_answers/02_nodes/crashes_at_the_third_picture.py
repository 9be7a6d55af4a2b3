# An error in a callback ends the program.
# loses: front_pictures, rear_pictures, shared_faults, alive_at_end
# cause: error.exception
# says: RuntimeError: buffer full
# replaces: self.frames += 1
self.frames += 1
if self.frames == 3:
    raise RuntimeError("buffer full")
