# Reports too often.
# loses: shared_faults
# cause: shared-faults.other-rate
# says: 5 Hz
# replaces: self.create_timer(1.0, self.report_faults)
self.create_timer(0.2, self.report_faults)
