# The rear camera never reports a fault.
# loses: shared_faults
# cause: shared-faults.silent
# says: /robot/rear_camera
# replaces: self.create_timer(1.0, self.report_faults)
if self.get_name() == "camera":
    self.create_timer(1.0, self.report_faults)
