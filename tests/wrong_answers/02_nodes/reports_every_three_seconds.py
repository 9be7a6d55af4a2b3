# Reports too rarely.
# loses: shared_faults
# cause: shared-faults.other-rate
# says: 0.33 Hz
# replaces: self.create_timer(1.0, self.report_faults)
self.create_timer(3.0, self.report_faults)
