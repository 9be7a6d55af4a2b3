# A gain of 0.9: the weights do not add up to one.
# loses: noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: noise-reduced.beside-the-joint
# replaces: message.position = filtered[0].tolist()
message.position = (0.9 * filtered[0]).tolist()
