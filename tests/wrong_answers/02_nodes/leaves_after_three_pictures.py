# Ends after three pictures of each camera.
# loses: front_pictures, rear_pictures, shared_faults, alive_at_end
# cause: silence.program-ended
# before: from typing import Any
import time

# replaces: for camera in make_cameras():
cameras = make_cameras()
for camera in cameras:

# replaces: try:
# replaces:     executor.spin()
# replaces: except (KeyboardInterrupt, ExternalShutdownException):
# replaces:     pass
# replaces: finally:
# replaces:     rclpy.try_shutdown()
while min(camera.frames for camera in cameras) < 3:
    executor.spin_once()
time.sleep(1.5)
rclpy.shutdown()
