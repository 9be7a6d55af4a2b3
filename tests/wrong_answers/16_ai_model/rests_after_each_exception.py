# Waits for three seconds each time when the model has raised.
# loses: survives
# cause: survives.pauses
# replaces: import threading
import threading
import time
# after: self.get_logger().error(f"The model gave up: {error}")
time.sleep(3.0)
