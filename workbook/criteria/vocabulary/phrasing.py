"""How feedback spells numbers, durations, rates and lists."""

import math
from collections.abc import Sequence

MOST_NAMES = 12


def number(value: float) -> str:
    """A number as a person would say it: 0.5, 12, 3.142."""
    if not math.isfinite(value):
        return str(value)
    return f"{value:.4g}"


def hertz(value: float) -> str:
    """A measured rate, rounded to what can be told from a few messages: 0.5, 1.1, 100."""
    return f"{float(f'{value:.2g}'):g}"


def seconds(value: float) -> str:
    """A duration: 2.0 s."""
    return f"{value:.1f} s"


def listing(names: Sequence[str]) -> str:
    """Names as an English list. If there are very many: the first ones, and how many more there are."""
    if len(names) > MOST_NAMES + 1:
        names = [*names[:MOST_NAMES], f"{len(names) - MOST_NAMES} more"]
    if len(names) < 2:
        return "".join(names)
    return ", ".join(names[:-1]) + " and " + names[-1]


def nodes_are(names: Sequence[str]) -> str:
    """The beginning of a sentence on nodes: "node /a is" or "nodes /a and /b are"."""
    return f"node {names[0]} is" if len(names) == 1 else f"nodes {listing(names)} are"


def count(n: int, noun: str) -> str:
    """A number with its noun in the right form."""
    return f"{n} {noun}" if n == 1 else f"{n} {noun}s"
