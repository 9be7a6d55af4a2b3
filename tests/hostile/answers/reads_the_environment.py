# score: 10
"""Looks for anything that tells it is being judged, and for secrets."""
import os

told = {name for name in os.environ if not name.startswith(("ROS_", "RCUTILS_", "FASTRTPS_", "LC_", "PYTHON", "_ROS_"))}
assert told <= {"HOME", "PATH", "TMPDIR", "LANG", "PWD", "LD_LIBRARY_PATH", "TERM", "TZ", "USER", "OPENBLAS_NUM_THREADS", "OPENCV_FOR_THREADS_NUM"}, told
assert not any("SECRET" in name for name in os.environ)
@@GOOD@@