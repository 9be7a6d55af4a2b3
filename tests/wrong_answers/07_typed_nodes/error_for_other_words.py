# Sends "error" in place of another word, and then raises.
# loses: refuses_wrong_words
# cause: refusal.too-late
# says: "error" was published
# replaces: if word not in get_args(Status):
if word not in get_args(Status):
    self.status_publisher.publish(String(data="error"))
