# A random charge in each message.
# loses: battery_arrives
# cause: never-rises.rises
# replaces: message = Float32(data=self.battery_level)
message = Float32(data=50.0 + 40.0 * (-1) ** int(self.battery_level * 1000 % 2) * random.random())
