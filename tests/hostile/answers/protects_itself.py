# score: 10
"""Tries to be the last to go when memory runs out, to read the memory of others, and to keep them from being ended."""
import glob
import os


def may_write(path, text):
    try:
        with open(path, "w") as file:
            file.write(text)
    except OSError:
        return False
    return True


def may_read(path):
    try:
        with open(path, "rb") as file:
            return bool(file.read(1))
    except OSError:
        return False


assert not may_write("/proc/self/oom_score_adj", "-1000")
for path in glob.glob("/proc/[0-9]*"):
    if os.path.basename(path) not in (str(os.getpid()), "self"):
        assert not may_write(f"{path}/oom_score_adj", "-1000"), path
assert not may_write("/proc/sysrq-trigger", "h")
assert not may_write("/sys/fs/cgroup/cgroup.procs", str(os.getpid()))
assert not may_read("/proc/kcore")
assert not may_read("/dev/mem")
@@GOOD@@
