# The mean of the last two messages.
# on: right/moving_average.py
# loses: noise_reduced
# cause: noise-reduced.too-little
# replaces: WINDOW = 7
WINDOW = 2
