# The hint allows a third word that the node refuses.
# loses: wrong_value_found
# cause: wrong-value-found.hint-too-wide
# replaces: def send_status(self, word: Status) -> None:
def send_status(self, word: Status | Literal["idle"]) -> None:
