# NumPy's float32 is no float of Python.
# loses: battery_arrives
# cause: really-arrives.wrong-type
# says: AssertionError
# before: import rclpy
import numpy as np

# replaces: message = Float32(data=self.battery_level)
message = Float32(data=np.float32(self.battery_level))
