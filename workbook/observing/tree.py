"""A process and what descends from it, as the kernel tells it."""

import os
from pathlib import Path


def children(pid: int) -> list[int]:
    """Processes that `pid` has started, or adopted; none when it has ended."""
    try:
        tasks = os.listdir(f"/proc/{pid}/task")
    except OSError:
        return []
    found: list[int] = []
    for task in tasks:
        try:
            found += [int(child) for child in Path(f"/proc/{pid}/task/{task}/children").read_text().split()]
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
