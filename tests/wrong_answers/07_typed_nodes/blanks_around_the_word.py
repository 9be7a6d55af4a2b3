# Strips blanks around the word before it looks.
# loses: refuses_wrong_words
# cause: refuses-wrong-words.check-too-loose
# replaces: if word not in get_args(Status):
if str(word).strip() not in get_args(Status):
