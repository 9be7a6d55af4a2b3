# Looks at the beginning of the text only.
# loses: refuses_wrong_words
# cause: refuses-wrong-words.check-too-loose
# replaces: if word not in get_args(Status):
if not word.startswith(get_args(Status)):
