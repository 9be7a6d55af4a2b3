# The array is made for whole numbers: 0.9 rad becomes 0.
# loses: noise_reduced, begins_near, restart_noticed, survives_nan, delay_bounded
# cause: noise-reduced.beside-the-joint
# replaces: message.position = filtered[0].tolist()
rounded = np.zeros(angles.size, dtype=int)
rounded[:] = filtered[0]
message.position = [float(angle) for angle in rounded]
