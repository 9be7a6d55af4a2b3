"""Format numbers, durations, rates, and lists for feedback."""

from collections.abc import Sequence
from decimal import Decimal

MOST_NAMES = 12
SMALLEST, LARGEST = 1e-9, 1e12
"""Numbers in this range are written without an exponent."""


def number(value: float) -> str:
    """Return a number as a person would write it: with at most four significant digits, and seldom an exponent.

    Examples are 0.5, 12, 3.142, and 137000. Only extreme numbers, such as 1e38, have an exponent.
    """
    text = f"{value:.4g}"
    return f"{Decimal(text):f}" if "e" in text and SMALLEST <= abs(value) < LARGEST else text


def hertz(value: float) -> str:
    """Return a measured rate (Hz) with two significant digits, because a few messages don't justify more digits."""
    return f"{float(f'{value:.2g}'):g}"


def seconds(value: float) -> str:
    """Return a duration with its unit, such as "2.0 s"."""
    return f"{value:.1f} s"


def listing(names: Sequence[str]) -> str:
    """Return names as an English list. A very long list is cut to its first names and the number of remaining names."""
    if len(names) > MOST_NAMES + 1:
        names = [*names[:MOST_NAMES], f"{len(names) - MOST_NAMES} more"]
    if len(names) < 2:
        return "".join(names)
    return ", ".join(names[:-1]) + " and " + names[-1]


def nodes_are(names: Sequence[str]) -> str:
    """Return the beginning of a sentence about nodes: "node /a is" or "nodes /a and /b are"."""
    return f"node {names[0]} is" if len(names) == 1 else f"nodes {listing(names)} are"


def count(n: int, noun: str) -> str:
    """Return a number with its noun, in the singular or plural."""
    return f"{n} {noun}" if n == 1 else f"{n} {noun}s"
