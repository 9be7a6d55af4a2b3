"""Find pairs of answers that differ only in names, comments, and layout. A match is a hint, never a verdict.

The method is winnowing, as in MOSS (Schleimer, Wilkerson, and Aiken, 2003) and as implemented by `copydetect`. Every
name is replaced with the same letter, and comments and spaces are removed. Of the rest, hashes of substrings, called
*fingerprints*, are compared. Short programs for the same task look alike even if no student has copied.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import Any

RUN = 25
"""The length, in characters, of the substring from which a fingerprint is computed.

`FOUND_FOR_SURE` is the length of the shortest common substring that's certain to be found. Both values are copydetect's
defaults.
"""
FOUND_FOR_SURE = 30
ALIKE = 0.9
"""The fraction of fingerprints that two answers must have in common to be listed."""
FEWEST = 10
"""The minimum number of fingerprints that an answer needs to be compared, not counting the starter's fingerprints."""
LONGEST = 100_000
"""The maximum length of an answer, in characters. Longer answers aren't compared."""


class NoComparison(RuntimeError):
    """Raised when answers can't be compared on this machine. The message says what to install."""


@dataclass(frozen=True)
class Pair:
    """Two students, and the fraction `share` of fingerprints that their answers have in common."""

    one: str
    other: str
    share: float


@dataclass(frozen=True)
class Comparison:
    """The similar pairs, most similar first, and the students whose answers couldn't be compared.

    `compared`: the number of answers that were compared.
    """

    pairs: tuple[Pair, ...]
    compared: int
    too_short: tuple[str, ...]
    too_long: tuple[str, ...]


def compare(answers: Mapping[str, str], starter: str) -> Comparison:
    """Compare all answers, keyed by student, with each other. Ignore code from the starter. Raises NoComparison."""
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
    return Comparison(
        tuple(alike), len(compared), tuple(name for name in prints if name not in compared), too_long
    )


def _fingerprints(text: str) -> set[int]:
    from copydetect.utils import winnow

    hashes = _hashes(text)
    if not len(hashes):
        return set()
    return {int(one) for one in winnow(hashes, FOUND_FOR_SURE - RUN + 1)[0]}


def _all_fingerprints(text: str) -> set[int]:
    return {int(one) for one in _hashes(text)}


def _hashes(text: str) -> Any:
    """Return an array with the hashes of all substrings of `RUN` characters."""
    try:
        from copydetect.utils import filter_code, hashed_kgrams
    except ImportError as error:
        raise NoComparison(
            "--similar needs copydetect, which students do not need: install it with `make env EXTRAS=similar`"
        ) from error
    return hashed_kgrams(filter_code(text, "answer.py", "python")[0], RUN)
