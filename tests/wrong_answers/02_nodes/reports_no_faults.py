# Nothing calls report_faults any more.
# loses: shared_faults
# cause: shared-faults.silent
# says: /robot/camera
# replaces: self.create_timer(1.0, self.report_faults)
