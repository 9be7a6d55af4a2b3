# An answer counts as ok, whatever it says.
# loses: results_told
# cause: results-told.always-the-same
# says: success=False
# replaces: self.report("ok" if future.result().success else "faulty")
self.report("ok" if future.result() else "faulty")
