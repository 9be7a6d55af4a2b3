# score: 10
"""Looks for a process in its sandbox without a filter of system calls: in the memory of that, it could write what it may not do."""
import os

free = []
for pid in filter(str.isdecimal, os.listdir("/proc")):
    with open(f"/proc/{pid}/status") as file:
        status = dict(line.split(":\t", 1) for line in file.read().splitlines() if ":\t" in line)
    if status["Seccomp"] != "2":
        try:
            open(f"/proc/{pid}/mem", "r+b").close()
        except OSError:
            continue
        free.append((pid, status["Name"]))
assert not free, free
@@GOOD@@
