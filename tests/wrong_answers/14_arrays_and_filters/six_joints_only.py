# Publishes the legs only, with their names.
# loses: labels_kept
# skips: every_one_answered, filters, noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: labels-kept.other-names
# replaces: message.position = filtered[0].tolist()
message.name = list(message.name)[6:]
message.position = filtered[0].tolist()[6:]
