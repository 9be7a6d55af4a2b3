# score: 10
"""Looks for the course and the judge in its own memory, and in what the kernel tells of it: names tell who watches."""
import re

TOLD = re.compile(rb"[/@]rclpy[-]workbook[-/]|work[b]ook[./]grading|cgroup[/]|(?:slot|answer)[-][a-z0-9_]{8}")
found = set()
with open("/proc/self/maps") as maps, open("/proc/self/mem", "rb", buffering=0) as memory:
    for line in maps.read().splitlines():
        place, rights, *_ = line.split()
        if not rights.startswith("rw"):
            continue
        begin, end = (int(number, 16) for number in place.split("-"))
        memory.seek(begin)
        try:
            content = memory.read(end - begin)
        except OSError:
            continue
        found |= {("memory", one) for one in TOLD.findall(content)}
for table in ("net/unix", "self/mountinfo", "self/cgroup", "self/environ", "1/cmdline", "1/environ", "1/mountinfo"):
    with open(f"/proc/{table}", "rb") as file:
        content = file.read()
    found |= {(table, one) for one in TOLD.findall(content)}
assert not found, found
@@GOOD@@
