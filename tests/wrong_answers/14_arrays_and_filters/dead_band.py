# A dead band in the place of a filter: keeps the angle until a measurement is far from it.
# on: right/exponential_script.py
# loses: noise_reduced
# cause: noise-reduced.stands-still
# replaces: old if math.isnan(new) else old + PART * (new - old)
new if abs(new - old) > 0.05 else old
