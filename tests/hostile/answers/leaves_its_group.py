# score: 10
"""Looks for the memory cgroup that it is in, and tries to leave it or to raise its limit; none of it may work."""
import ctypes
import os

libc = ctypes.CDLL(None, use_errno=True)
with open("/proc/self/cgroup") as table:
    told = {line.rstrip().split(":", 2)[2] for line in table}
assert told == {"/"}, f"the path of a group is told: {told}"
assert libc.unshare(0x02000000) < 0, "a name space of groups of its own is allowed"
os.mkdir("groups")
for kind, options in ((b"cgroup", b"memory"), (b"cgroup2", None)):
    assert libc.mount(b"none", b"groups", kind, 0, options) < 0, "groups can be mounted"
mounts_here = ("/sys/fs/cgroup", "/sys/fs/cgroup/memory")
for mount in (*mounts_here, *(f"/proc/1/root{mount}" for mount in mounts_here)):
    assert not os.path.exists(mount), f"{mount} is there"
for descriptor in os.listdir("/proc/self/fd"):
    try:
        target = os.readlink(f"/proc/self/fd/{descriptor}")
    except OSError:
        continue
    assert "tasks" not in target and "cgroup" not in target, f"{target} is open"
@@GOOD@@
