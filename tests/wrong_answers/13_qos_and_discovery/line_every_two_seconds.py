# A frequency as a period.
# loses: line_rate
# cause: rate.period-for-frequency
# replaces: LINE_PERIOD_S = 0.5
LINE_PERIOD_S = 2.0
