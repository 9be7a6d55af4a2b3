# A gain of 0.9: the weights do not add up to one.
# loses: filters
# skips: noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: filters.gain
# replaces: message.position = filtered[0].tolist()
message.position = (0.9 * filtered[0]).tolist()
