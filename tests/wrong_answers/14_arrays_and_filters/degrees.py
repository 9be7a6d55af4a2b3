# Publishes degrees.
# loses: filters
# skips: noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: filters.gain
# replaces: message.position = filtered[0].tolist()
message.position = np.rad2deg(filtered[0]).tolist()
