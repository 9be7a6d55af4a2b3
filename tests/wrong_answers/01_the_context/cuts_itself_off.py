# Parks, and then cuts the process off before anything is cleaned up.
# loses: node_gone
# cause: nodes-gone-at-end.cut-off
# before: import rclpy
import os

# replaces: guard.destroy_node()
# replaces: rclpy.try_shutdown()
os._exit(0)
