# Says "no answer" whenever it sends a request, whether the last call was answered or not.
# loses: unanswered_told
# cause: unanswered-told.besides-the-answer
# replaces: self.report("no answer")

# after: self.open_call.add_done_callback(self.on_answer)
self.report("no answer")
