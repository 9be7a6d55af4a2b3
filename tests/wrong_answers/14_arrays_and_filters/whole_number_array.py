# The array is made for whole numbers: 0.9 rad becomes 0.
# loses: filters
# skips: noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: filters.whole-numbers
# replaces: message.position = filtered[0].tolist()
rounded = np.zeros(angles.size, dtype=int)
rounded[:] = filtered[0]
message.position = [float(angle) for angle in rounded]
