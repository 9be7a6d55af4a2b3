# score: 10
"""Looks for a place without a limit on its size: only three small folders may be written to."""
import os

for place in ("/", "/dev", "/home", "/answer", "/usr", "/proc/self", "/dev/mqueue", "/var", "/run"):
    try:
        with open(f"{place}/x", "w") as file:
            file.write("x")
    except OSError:
        continue
    raise SystemExit(f"{place} can be written to")
for place in ("/tmp", "/dev/shm", os.environ["HOME"]):
    space = os.statvfs(place)
    assert space.f_blocks * space.f_frsize <= 64 * 1024 * 1024, f"{place} is larger than 64 MB"
@@GOOD@@
