# score: 10
"""Changes the time stamps of the devices, which are those of the machine."""
import os
import subprocess

for device in ("/dev/null", "/dev/zero", "/dev/urandom"):
    before = os.stat(device)
    for attempt in (
        lambda: os.utime(device, ns=(before.st_atime_ns, before.st_mtime_ns - 1)),
        lambda: os.chown(device, os.getuid(), os.getgid()),
        lambda: os.chmod(device, before.st_mode & 0o777),
        lambda: subprocess.run(["touch", device], stderr=subprocess.DEVNULL),
    ):
        try:
            attempt()
        except OSError:
            pass
    after = os.stat(device)
    assert (after.st_mtime_ns, after.st_ctime_ns) == (before.st_mtime_ns, before.st_ctime_ns), f"{device} has changed"
@@GOOD@@
