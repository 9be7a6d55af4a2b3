# Looks for a text that never comes, so every answer is faulty.
# loses: results_told
# cause: results-told.always-faulty
# replaces: self.report("ok" if future.result().success else "faulty")
self.report("ok" if future.result().message == "ok" else "faulty")
