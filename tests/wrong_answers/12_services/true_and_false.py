# Other words than the ones that were agreed on.
# loses: health_topic
# skips: results_told, unanswered_told
# cause: one-of.other-text
# says: "True" on /robot/health
# replaces: self.report("ok" if future.result().success else "faulty")
self.report(str(future.result().success))
