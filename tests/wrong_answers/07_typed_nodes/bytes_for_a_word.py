# Decodes a word that comes as bytes, from a network perhaps.
# loses: refuses_wrong_words
# cause: refuses-wrong-words.check-too-loose
# says: send_status(b'error')
# before: if word not in get_args(Status):
if isinstance(word, bytes):
    word = "error"
