# Waits 1.2 s between an answer and its report.
# loses: results_told
# cause: results-told.delayed
# replaces: import rclpy
from threading import Timer

import rclpy

# replaces: self.report("ok" if future.result().success else "faulty")
Timer(1.2, self.report, ["ok" if future.result().success else "faulty"]).start()
