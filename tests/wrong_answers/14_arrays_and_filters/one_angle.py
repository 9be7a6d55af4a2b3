# The wrong index: one angle in the place of twelve.
# loses: labels_kept
# skips: every_one_answered, filters, noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: labels-kept.other-length
# replaces: message.position = filtered[0].tolist()
message.position = [filtered.tolist()[0][0]]
