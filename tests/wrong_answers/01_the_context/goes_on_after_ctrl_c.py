# Catches Ctrl-C inside of the loop and goes on.
# loses: arms_parked, ends_cleanly, node_gone
# cause: arms-parked.ignores-ctrl-c
# before: import rclpy
import time

# replaces: try:
# replaces:     rclpy.spin(guard)
# replaces: except (KeyboardInterrupt, ExternalShutdownException):
# replaces:     pass  # this is how a night ends
# replaces: finally:
# replaces:     guard.park()
# replaces:     guard.destroy_node()
# replaces:     rclpy.try_shutdown()
while True:
    try:
        rclpy.spin_once(guard, timeout_sec=0.5)
    except Exception:
        time.sleep(0.1)
    except KeyboardInterrupt:
        print("still on duty")
