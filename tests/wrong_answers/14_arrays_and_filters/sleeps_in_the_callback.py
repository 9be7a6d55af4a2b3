# Sleeps in each callback, a little longer than the time between two messages.
# loses: every_one_answered
# also: restart_noticed
# cause: every-one-answered.falls-behind, every-one-answered.late
# before: self.publisher.publish(message)
time.sleep(0.06)

# before: import numpy as np
import time

