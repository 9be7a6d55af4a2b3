# Takes the word in capital letters, too.
# loses: refuses_wrong_words
# cause: refuses-wrong-words.check-too-loose
# replaces: if word not in get_args(Status):
if str(word).lower() not in get_args(Status):
