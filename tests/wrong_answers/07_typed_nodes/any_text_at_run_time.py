# Checks at run time only that the word is a text.
# loses: refuses_wrong_words
# cause: refuses-wrong-words.accepted
# replaces: if word not in get_args(Status):
if not isinstance(word, str):
