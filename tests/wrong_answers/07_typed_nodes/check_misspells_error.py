# Compares with a misspelled word, so "error" is refused.
# loses: refuses_wrong_words
# cause: refuses-wrong-words.good-word-refused
# replaces: if word not in get_args(Status):
if word not in ("operational", "eror"):
