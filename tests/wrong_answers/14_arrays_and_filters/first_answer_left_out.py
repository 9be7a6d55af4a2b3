# The first message after a start only fills the memory.
# loses: every_one_answered
# cause: every-one-answered.first-left-out
# after: self.memory = AT_REST[:, :, np.newaxis] * angles
self.last_good, self.last_stamp = angles, stamp
return

