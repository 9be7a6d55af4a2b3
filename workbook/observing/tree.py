"""A process and what descends from it, as the kernel tells it."""

import os


def read_proc(path: str) -> bytes:
    """What the kernel tells in a small file below /proc. Raises OSError when its process has ended.

    Asked many times a second: a `Path` would cost three times as much.
    """
    with open(path, "rb", buffering=0) as file:
        return file.read()


def seconds_in_line(pid: int) -> float:
    """How long (s) a process was ready to run and had no processor, up to now; zero when it has ended.

    Counted for its first thread. Source: https://docs.kernel.org/scheduler/sched-stats.html (/proc/<pid>/schedstat).
    """
    try:
        return int(read_proc(f"/proc/{pid}/schedstat").split()[1]) / 1e9
    except (OSError, IndexError):
        return 0.0


def children(pid: int) -> list[int]:
    """Processes that `pid` has started, or adopted; none when it has ended."""
    try:
        tasks = os.listdir(f"/proc/{pid}/task")
    except OSError:
        return []
    found: list[int] = []
    for task in tasks:
        try:
            found += map(int, read_proc(f"/proc/{pid}/task/{task}/children").split())
        except OSError:
            continue
    return found


def process_tree(pid: int) -> list[int]:
    """`pid` and all its descendants."""
    tree = {pid: None}
    waiting = [pid]
    while waiting:
        born = [child for child in children(waiting.pop()) if child not in tree]
        tree.update(dict.fromkeys(born))
        waiting += born
    return [*tree]
