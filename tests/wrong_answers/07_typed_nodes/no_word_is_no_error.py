# Ignores None without an error.
# loses: refuses_wrong_words
# cause: refuses-wrong-words.check-too-loose
# says: send_status(None)
# replaces: def send_status(self, word: Status) -> None:
def send_status(self, word: Status) -> None:
    if word in (None,):
        return
