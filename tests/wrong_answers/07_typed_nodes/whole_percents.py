# The hint asks for a whole number.
# loses: clean, right_use
# skips: wrong_message_found, wrong_value_found
# cause: mypy.wrong-argument
# replaces: def send_battery(self, level: float) -> None:
def send_battery(self, level: int) -> None:
