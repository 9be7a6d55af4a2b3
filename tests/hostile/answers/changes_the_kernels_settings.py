# score: 10
"""Tries to change settings of the whole machine, which belong to root: the grader may be root."""
import os

for folder, _, names in os.walk("/proc/sys"):
    for name in names:
        try:
            os.close(os.open(f"{folder}/{name}", os.O_WRONLY))
        except OSError:
            continue
        raise SystemExit(f"{folder}/{name} can be written to")
before = os.stat("/dev/full").st_mode
try:
    os.chmod("/dev/full", before ^ 0o001)
except OSError:
    pass
after = os.stat("/dev/full").st_mode
if after != before:
    os.chmod("/dev/full", before)
    raise SystemExit("the devices of the machine can be changed")
with open("/dev/null", "w") as nothing:
    nothing.write("a device can be used all the same")
@@GOOD@@
