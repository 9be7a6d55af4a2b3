# Takes each text that names a joint for a fault.
# loses: results_told
# cause: results-told.follows-the-text
# replaces: self.report("ok" if future.result().success else "faulty")
named = any(joint in future.result().message for joint in ("knee", "elbow", "hip", "neck"))
self.report("faulty" if named else "ok")
