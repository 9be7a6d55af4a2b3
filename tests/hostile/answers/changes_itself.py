# score: 10
"""Tries to remove and to rewrite its own file, the host's, and the interpreter's packages."""
import os
import sys

import rclpy

for path in (__file__, rclpy.__file__, sys.executable):
    try:
        with open(path, "a") as file:
            file.write("# owned")
        raise SystemExit(f"{path} can be written")
    except OSError:
        pass
    try:
        os.remove(path)
        raise SystemExit(f"{path} can be removed")
    except OSError:
        pass
@@GOOD@@