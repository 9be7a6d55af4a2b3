# Catches Ctrl-C, and prints its traceback all the same.
# loses: ends_cleanly
# cause: exits-cleanly.prints-a-traceback
# before: import rclpy
import traceback

# replaces: pass  # this is how a night ends
traceback.print_exc()
