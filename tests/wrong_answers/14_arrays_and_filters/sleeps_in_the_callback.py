# Sleeps for a tenth of a second in each callback, where twenty messages a second come.
# loses: every_one_answered
# cause: every-one-answered.late, every-one-answered.missing
# before: self.publisher.publish(message)
time.sleep(0.1)

# before: import numpy as np
import time

