# Leaves with exit code 1, as if the night had gone wrong.
# loses: ends_cleanly
# cause: exits-cleanly.exit-code
# says: exit code 1
# before: import rclpy
import sys

# replaces: pass  # this is how a night ends
sys.exit(1)
