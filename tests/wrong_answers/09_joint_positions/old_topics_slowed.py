# Status and battery were slowed down to make room.
# loses: status_kept, battery_kept
# cause: rate.evenly-too-slow, rate.too-slow
# replaces: STATUS_PERIOD_S = 1.0
# replaces: BATTERY_PERIOD_S = 2.0
STATUS_PERIOD_S = 5.0
BATTERY_PERIOD_S = 5.0
