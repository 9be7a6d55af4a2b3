# A joint that gave NaN once is never measured again.
# on: right/exponential_script.py
# loses: noise_reduced, survives_nan
# cause: noise-reduced.held-after-restart
# replaces: last = (0, 0)
last = (0, 0)
broken = set()

# after: last = stamp
broken.update(place for place, angle in enumerate(message.position) if math.isnan(angle))

# replaces: old if math.isnan(new) else old + PART * (new - old)
# replaces: for old, new in zip(angles, message.position)
old if place in broken else old + PART * (new - old)
for place, (old, new) in enumerate(zip(angles, message.position))
