# Takes the first angles for an offset of the encoders, and subtracts them.
# loses: filters
# skips: noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: filters.nothing-left
# after: self.memory = AT_REST[:, :, np.newaxis] * angles
self.offset = angles

# replaces: message.position = filtered[0].tolist()
message.position = (filtered[0] - self.offset).tolist()
