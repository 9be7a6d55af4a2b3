# The period of the battery is 5 % too short: only one message too many in the minute.
# loses: battery_count
# cause: keeps-period.other-period
# says: 1.9 s
# replaces: BATTERY_PERIOD_S = 2.0  # 0.5 Hz: one message every two seconds
BATTERY_PERIOD_S = 1.9
