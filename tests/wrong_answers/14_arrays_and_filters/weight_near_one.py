# Smoothing that takes four fifths of what is new: a filter, but a weak one.
# on: right/exponential_script.py
# loses: noise_reduced
# cause: noise-reduced.too-little
# replaces: PART = 0.25
PART = 0.8
