# Looks at the text for people, and not at the field success.
# loses: results_told
# cause: results-told.follows-the-text
# replaces: self.report("ok" if future.result().success else "faulty")
self.report("ok" if future.result().message.startswith("all") else "faulty")
