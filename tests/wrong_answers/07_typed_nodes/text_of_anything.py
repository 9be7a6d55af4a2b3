# Makes a text of what it is given before it checks, so that an object may name the word.
# loses: refuses_wrong_words
# cause: refuses-wrong-words.check-too-loose
# says: send_status(Path('error'))
# replaces: if word not in get_args(Status):
if str(word) not in get_args(Status):

# replaces: self.status_publisher.publish(String(data=word))
self.status_publisher.publish(String(data=str(word)))
