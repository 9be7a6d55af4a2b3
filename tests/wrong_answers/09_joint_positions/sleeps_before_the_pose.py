# The joint callback takes 1.9 s before it publishes, and all other timers wait.
# loses: joint_rate, status_kept
# cause: rate.begins-late
# after: import random
import time

# before: self.joint_publisher.publish(message)
time.sleep(1.9)
