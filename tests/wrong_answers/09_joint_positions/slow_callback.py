# The joint callback takes 1.9 s, and all other timers wait.
# loses: status_kept
# cause: rate.groups-with-silences
# after: import random
import time

# after: self.joint_publisher.publish(message)
time.sleep(1.9)
