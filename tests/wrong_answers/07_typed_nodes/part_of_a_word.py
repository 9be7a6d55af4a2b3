# Looks for the word in a text: "oper" is in it, and an empty one, too.
# loses: refuses_wrong_words
# cause: refuses-wrong-words.check-too-loose
# replaces: if word not in get_args(Status):
if str(word) not in "operational error":
