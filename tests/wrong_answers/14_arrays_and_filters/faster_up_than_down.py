# Follows an angle upward faster than downward.
# on: right/exponential_script.py
# loses: noise_reduced
# cause: noise-reduced.to-one-side
# replaces: old if math.isnan(new) else old + PART * (new - old)
old if math.isnan(new) else old + (0.4 if new > old else 0.15) * (new - old)
