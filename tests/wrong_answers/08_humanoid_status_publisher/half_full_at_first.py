# The battery begins with half its charge.
# loses: battery_arrives
# cause: begins-full.not-full
# replaces: self.battery_level = 100.0
self.battery_level = 50.0
