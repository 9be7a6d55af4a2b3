# Makes the cameras, and waits for Ctrl-C without a spin.
# loses: front_pictures, rear_pictures, shared_faults
# cause: pictures.nothing-spins
# before: from typing import Any
import time

# replaces: executor.spin()
time.sleep(1000.0)
