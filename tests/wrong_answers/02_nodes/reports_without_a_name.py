# Reports do not say whose they are.
# loses: shared_faults
# cause: shared-faults.nameless
# says: 'none'
# replaces: self.fault_publisher.publish(String(data=f"{self.get_name()}: none"))
self.fault_publisher.publish(String(data="none"))
