# The level has a default, so a call that forgets the number sends 0.0.
# loses: wrong_value_found
# cause: wrong-value-found.default
# says: robot.send_battery()
# replaces: def send_battery(self, level: float) -> None:
def send_battery(self, level: float = 0.0) -> None:
