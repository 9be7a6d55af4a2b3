# score: 10
"""Looks for a process in its sandbox that no filter of system calls holds: in its place, it could do what it may not."""
import os

free = []
for pid in filter(str.isdecimal, os.listdir("/proc")):
    try:
        with open(f"/proc/{pid}/status") as file:
            status = dict(line.split(":\t", 1) for line in file.read().splitlines() if ":\t" in line)
    except (FileNotFoundError, ProcessLookupError):  # it ended after it was listed
        continue
    if status["Seccomp"] != "2":
        free.append((pid, status["Name"]))
assert not free, free
@@GOOD@@
