# The last joint goes past the filter.
# loses: noise_reduced
# cause: noise-reduced.some-joints
# replaces: message.position = filtered[0].tolist()
message.position = [*filtered[0].tolist()[:11], angles.tolist()[11]]
