# Several calls may be open; the answer to one of them makes it forget all of them.
# on: right/several_calls_open.py
# loses: unanswered_told
# cause: unanswered-told.forgotten
# replaces: if self.open.pop(future, None) is not None:
if future in self.open:
    self.open.clear()
