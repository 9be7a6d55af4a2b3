"""A process and what descends from it, as the kernel tells it."""

import os


def read_proc(path: str) -> bytes:
    """What the kernel tells in a small file below /proc. Raises OSError when its process has ended.

    Asked many times a second: a `Path` would cost three times as much.
    """
    with open(path, "rb", buffering=0) as file:
        return file.read()


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
