"""Pairs of answers that are the same but for names, comments, and layout: a hint, and never a verdict.

The method is winnowing, as MOSS does it (Schleimer, Wilkerson and Aiken, 2003), in the form of `copydetect`: names
become one letter, comments and spaces go, and what remains is compared by fingerprints. Short programs for one task
look alike even if no student copied.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import Any

RUN = 25
"""Characters of a fingerprint, and below, the shortest run that is found for sure: the defaults of copydetect."""
FOUND_FOR_SURE = 30
ALIKE = 0.9
"""The share of fingerprints that two answers must have in common to be listed."""
FEWEST = 10
"""Fingerprints beyond the starter's. With fewer, an answer says too little to be compared."""
LONGEST = 100_000
"""Characters of an answer that is compared."""


class NoComparison(RuntimeError):
    """Answers cannot be compared here. The message says what to install."""


@dataclass(frozen=True)
class Pair:
    """Two students, and the share of their answers' fingerprints that both have."""

    one: str
    other: str
    share: float


@dataclass(frozen=True)
class Comparison:
    """The pairs that are alike, most alike first; and who could not be compared."""

    pairs: tuple[Pair, ...]
    compared: int
    too_short: tuple[str, ...]
    too_long: tuple[str, ...]


def compare(answers: Mapping[str, str], starter: str) -> Comparison:
    """Compare all answers with each other, by student; lines of the starter do not count. Raises NoComparison."""
    common = _all_fingerprints(starter)
    too_long = tuple(sorted(name for name, text in answers.items() if len(text) > LONGEST))
    prints = {
        name: _fingerprints(text) - common for name, text in sorted(answers.items()) if name not in too_long
    }
    compared = {name: found for name, found in prints.items() if len(found) >= FEWEST}
    pairs = [
        Pair(one, other, len(mine & theirs) / len(mine | theirs))
        for (one, mine), (other, theirs) in combinations(compared.items(), 2)
        if min(len(mine), len(theirs)) >= ALIKE * max(len(mine), len(theirs))
    ]
    alike = [pair for pair in pairs if pair.share >= ALIKE]
    alike.sort(key=lambda pair: (-pair.share, pair.one, pair.other))
    return Comparison(tuple(alike), len(compared), tuple(prints.keys() - compared.keys()), too_long)


def _fingerprints(text: str) -> set[int]:
    from copydetect.utils import winnow

    hashes = _hashes(text)
    if not len(hashes):
        return set()
    return {int(one) for one in winnow(hashes, FOUND_FOR_SURE - RUN + 1)[0]}


def _all_fingerprints(text: str) -> set[int]:
    return {int(one) for one in _hashes(text)}


def _hashes(text: str) -> Any:
    """The array of the hashes of all runs."""
    try:
        from copydetect.utils import filter_code, hashed_kgrams
    except ImportError as error:
        raise NoComparison(
            "--similar needs copydetect, which students do not need: install it with `make env EXTRAS=similar`"
        ) from error
    return hashed_kgrams(filter_code(text, "answer.py", "python")[0], RUN)
