# Waits for five seconds when the model has raised, as if the accelerator needed a rest.
# loses: survives
# cause: survives.pauses
# replaces: import threading
import threading
import time
# after: self.get_logger().error(f"The model gave up: {error}")
time.sleep(5.0)
