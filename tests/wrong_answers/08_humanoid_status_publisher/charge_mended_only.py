# Of the starter's three mistakes, one is fixed: the whole number in a float field.
# loses: battery_rate, ends_cleanly
# cause: rate.period-for-frequency
# on: starter
# replaces: message = Float32(data=round(self.battery_level))  # whole percents are easier to read
message = Float32(data=self.battery_level)
