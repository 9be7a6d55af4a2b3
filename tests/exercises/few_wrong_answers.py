"""Chooses the wrong answers that `make test` runs: as few as break every criterion of an exercise once."""

from collections.abc import Mapping
from pathlib import Path


def few_that_break_all(loses: Mapping[Path, frozenset[str]]) -> frozenset[Path]:
    """Return few of these wrong answers that together lose every criterion that any of them loses.

    Greedy: each step takes the answer that loses most of what is still missing, the first by name where several do.
    An answer that loses one criterion proves more than one that loses all, so whoever loses least goes first among
    equals.
    """
    missing = frozenset[str]().union(*loses.values())
    chosen: set[Path] = set()
    while missing:
        best = min(loses, key=lambda path: (-len(loses[path] & missing), len(loses[path]), path.name))
        chosen.add(best)
        missing -= loses[best]
    return frozenset(chosen)
