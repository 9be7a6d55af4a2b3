# Publishes a last message after Ctrl-C, when the context is shut down.
# loses: ends_cleanly
# cause: error.context-down
# after: import random
import time

# replaces: pass  # someone ended the program, which isn't an error
time.sleep(0.5)
humanoid.status_publisher.publish(String(data="error"))
