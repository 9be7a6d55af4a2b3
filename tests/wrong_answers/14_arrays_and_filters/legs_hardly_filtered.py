# Gives new measurements of the legs much more weight than those of the arms.
# loses: noise_reduced
# cause: noise-reduced.unlike-joints
# replaces: message.position = filtered[0].tolist()
message.position = [*filtered[0][:6].tolist(), *(0.15 * filtered[0] + 0.85 * angles)[6:].tolist()]
