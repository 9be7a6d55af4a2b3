# The hint allows None.
# loses: wrong_value_found
# cause: wrong-value-found.hint-too-wide
# says: `robot.send_battery(None)`
# replaces: def send_battery(self, level: float) -> None:
def send_battery(self, level: float | None) -> None:
