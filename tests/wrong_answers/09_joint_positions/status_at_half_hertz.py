# The status comes every two seconds, like the other topics.
# loses: status_kept
# cause: rate.evenly-too-slow, rate.too-slow
# replaces: STATUS_PERIOD_S = 1.0
STATUS_PERIOD_S = 2.0
