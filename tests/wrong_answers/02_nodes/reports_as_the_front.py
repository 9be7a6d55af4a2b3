# Both cameras report under the name of the front camera.
# loses: shared_faults
# cause: shared-faults.name-of-the-other
# says: no report begins with 'rear_camera:'
# replaces: self.fault_publisher.publish(String(data=f"{self.get_name()}: none"))
self.fault_publisher.publish(String(data="camera: none"))
