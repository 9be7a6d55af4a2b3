# Removes blanks at the end before it compares, and sends the word with them.
# loses: refuses_wrong_words
# cause: refuses-wrong-words.check-too-loose
# says: send_status('error\n')
# replaces: if word not in get_args(Status):
if word.rstrip() not in get_args(Status):
