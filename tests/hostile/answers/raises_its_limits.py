# score: 10
"""Tries to get more than it may have: higher limits, and to go before all others."""
import os
import resource

for limit in (resource.RLIMIT_AS, resource.RLIMIT_FSIZE, resource.RLIMIT_NOFILE, resource.RLIMIT_CPU, resource.RLIMIT_CORE):
    soft, hard = resource.getrlimit(limit)
    assert hard != resource.RLIM_INFINITY, f"limit {limit} is not set"
    try:
        resource.setrlimit(limit, (hard + 1, hard + 1))
    except (ValueError, OSError):
        continue
    raise SystemExit(f"limit {limit} can be raised")
for what, attempt in {
    "nice": lambda: os.nice(-5),
    "real time": lambda: os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(1)),
    "safe from the lack of memory": lambda: open("/proc/self/oom_score_adj", "w").write("-1000"),
}.items():
    try:
        attempt()
    except OSError:
        continue
    raise SystemExit(f"allowed: {what}")
@@GOOD@@
