# score: 10
"""Sets the older variable that keeps ROS on one machine: it is heard all the same."""
import os

os.environ["ROS_LOCALHOST_ONLY"] = "1"
@@GOOD@@
