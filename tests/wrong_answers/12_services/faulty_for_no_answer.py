# A call without an answer is reported as faulty.
# loses: results_told, unanswered_told
# cause: results-told.no-answer-came
# replaces: self.report("no answer")
self.report("faulty")
