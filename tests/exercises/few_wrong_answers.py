"""Choose the wrong answers that `make test` runs: as few as possible, but each criterion must fail at least once."""

from collections.abc import Mapping
from pathlib import Path


def few_that_break_all(loses: Mapping[Path, frozenset[str]]) -> frozenset[Path]:
    """Return a few of these wrong answers that together lose every criterion that any of them loses.

    The choice is greedy: each step takes the answer that loses the most criteria that are still missing. Among equals,
    the one that loses the fewest criteria in total goes first, because it proves more than one that loses all. The
    names break remaining ties.
    """
    missing = frozenset[str]().union(*loses.values())
    chosen: set[Path] = set()
    while missing:
        best = min(loses, key=lambda path: (-len(loses[path] & missing), len(loses[path]), path.name))
        chosen.add(best)
        missing -= loses[best]
    return frozenset(chosen)
