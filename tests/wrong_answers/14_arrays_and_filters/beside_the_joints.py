# Adds a number to every angle.
# loses: filters
# skips: noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: filters.offset
# replaces: message.position = filtered[0].tolist()
message.position = (filtered[0] + 0.07).tolist()
