# score: 0
# says: ROS_AUTOMATIC_DISCOVERY_RANGE
"""Turns discovery off, so that nobody can find its node."""
import os

os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "OFF"
@@GOOD@@
