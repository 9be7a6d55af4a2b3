# Raises an error for the first wrong word, and sends the next ones.
# loses: refuses_wrong_words
# cause: refuses-wrong-words.check-too-loose
# after: self.level = 100.0
self.refused = False

# replaces: if word not in get_args(Status):
if word not in get_args(Status) and not self.refused:
    self.refused = True
