# score: 0
# says: is on domain 130
"""Goes to another domain."""
import os

os.environ["ROS_DOMAIN_ID"] = "130"
@@GOOD@@