# One number is the memory of all joints, one after the other.
# on: right/exponential_script.py
# loses: filters
# skips: noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: filters.mixes-joints
# replaces: angles = [
# replaces:     old if math.isnan(new) else old + PART * (new - old)
# replaces:     for old, new in zip(angles, message.position)
# replaces: ]
one, filtered = angles[-1], []
for new in message.position:
    one = one if math.isnan(new) else one + PART * (new - one)
    filtered.append(one)
angles = filtered
