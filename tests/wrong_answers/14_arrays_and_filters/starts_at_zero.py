# The memory begins with zeros.
# loses: begins_near, restart_noticed
# cause: begins-near.swings-in
# replaces: self.memory = AT_REST[:, :, np.newaxis] * angles
self.memory = AT_REST[:, :, np.newaxis] * np.zeros_like(angles)
