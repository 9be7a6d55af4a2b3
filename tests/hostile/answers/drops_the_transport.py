# score: 10
"""Throws away what the environment says of the transport: it is heard all the same."""
import os
import sys

if "FASTRTPS_DEFAULT_PROFILES_FILE" in os.environ:
    del os.environ["FASTRTPS_DEFAULT_PROFILES_FILE"]
    os.execv(sys.executable, [sys.executable, __file__, *sys.argv[1:]])
@@GOOD@@
