# Agrees on a third word with nobody.
# loses: wrong_value_found, refuses_wrong_words
# cause: wrong-value-found.hint-too-wide
# replaces: Status = Literal["operational", "error"]
Status = Literal["operational", "error", "charging"]
