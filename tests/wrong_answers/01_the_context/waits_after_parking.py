# A thread that is no daemon goes on, so the program does not end.
# loses: ends_cleanly, node_gone
# cause: ends-cleanly.goes-on-after-parking
# before: import rclpy
import threading
import time

# after: guard = NightGuard()
threading.Thread(target=time.sleep, args=(1000.0,)).start()

# replaces: guard.destroy_node()
# replaces: rclpy.try_shutdown()
