# Stops reporting after six pictures, and takes more of them.
# loses: shared_faults
# cause: shared-faults.other-rate
# says: then nothing
# before: self.fault_publisher.publish(String(data=f"{self.get_name()}: none"))
if self.frames > 6:
    return
