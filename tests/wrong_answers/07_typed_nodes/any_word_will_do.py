# The hint allows every text.
# loses: wrong_value_found
# cause: wrong-value-found.hint-too-wide
# says: `robot.send_status("operatoinal")`
# replaces: def send_status(self, word: Status) -> None:
def send_status(self, word: str) -> None:
