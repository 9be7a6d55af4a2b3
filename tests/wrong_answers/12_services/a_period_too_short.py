# Calls every 0.85 s.
# loses: asks_every_second
# cause: asks-every-second.short-period
# replaces: ASK_PERIOD_S = 1.0
ASK_PERIOD_S = 0.85
