# The mean of the last 25 messages.
# on: right/moving_average.py
# loses: delay_bounded
# cause: delay-bounded.too-late
# replaces: WINDOW = 7
WINDOW = 25
