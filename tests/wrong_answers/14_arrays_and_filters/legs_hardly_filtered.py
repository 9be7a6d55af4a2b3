# Gives new measurements of the legs nearly all the weight, and not those of the arms.
# loses: noise_reduced
# cause: noise-reduced.unlike-joints
# replaces: message.position = filtered[0].tolist()
message.position = [*filtered[0][:6].tolist(), *(0.1 * filtered[0] + 0.9 * angles)[6:].tolist()]
