# score: 10
# copies: 2
"""Looks for a copy of itself in another sandbox, by a file of the interpreter that both can read."""
import ctypes
import fcntl
import json

libc = ctypes.CDLL(None, use_errno=True)
ATTEMPTS = {
    "a lock of the whole file": lambda file: fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB),
    "a lock of a part": lambda file: fcntl.lockf(file, fcntl.LOCK_SH | fcntl.LOCK_NB),
    "a lease": lambda file: fcntl.fcntl(file, fcntl.F_SETLEASE, fcntl.F_RDLCK),
}
meeting = open(json.__file__)
for name, attempt in ATTEMPTS.items():
    try:
        attempt(meeting)
    except OSError:
        continue
    raise SystemExit(f"{name} is seen in other sandboxes")
assert libc.inotify_init1(0) < 0, "it may hear who else opens a file"
assert libc.fanotify_init(0x200, 0) < 0, "it may hear who else opens a file"
@@GOOD@@
