# The joint callback sleeps for half a minute after its message.
# loses: joints_move, joint_rate, status_kept, battery_kept
# cause: varies.one-message
# after: import random
import time

# after: self.joint_publisher.publish(message)
time.sleep(30.0)
