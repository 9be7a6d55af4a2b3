# Of the starter's three mistakes, one is fixed: the period.
# loses: battery_arrives, ends_cleanly
# cause: really-arrives.wrong-type
# says: line 40
# on: starter
# replaces: BATTERY_PERIOD_S = 0.5  # 0.5 Hz
BATTERY_PERIOD_S = 2.0
