# Rounds what it publishes.
# loses: noise_reduced
# cause: noise-reduced.rounded
# replaces: message.position = filtered[0].tolist()
message.position = np.round(filtered[0], 1).tolist()
