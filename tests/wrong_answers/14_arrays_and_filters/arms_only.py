# Filters the upper body only.
# loses: noise_reduced
# cause: noise-reduced.some-joints
# replaces: message.position = filtered[0].tolist()
message.position = [*filtered[0].tolist()[:6], *angles.tolist()[6:]]
