# score: 0
# says: RMW_IMPLEMENTATION
"""Asks for a middleware that is not there."""
import os
import sys

if "RMW_IMPLEMENTATION" not in os.environ:
    os.environ["RMW_IMPLEMENTATION"] = "rmw_cyclonedds_cpp"
    os.execv(sys.executable, [sys.executable, __file__, *sys.argv[1:]])
@@GOOD@@
