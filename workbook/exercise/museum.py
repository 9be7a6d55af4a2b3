"""Load the error museum: the mistakes of each lesson, with their causes and fixes, and each lesson's terms.

Each lesson has a file `notebooks/sources/museum/NN_slug.toml`. Web pages and feedback are generated from these files.
"""

import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

SHORTEST_SYMPTOM_TEXT = 12
"""In characters. A shorter string occurs in too many outputs to identify an error."""


class BrokenMuseum(ValueError):
    """Raised when a museum file can't be used. The message says where and why."""


@dataclass(frozen=True)
class Exhibit:
    """One mistake.

    `symptom`: the mistake as a student sees it. `shows`: a part of the output of the cell `cell` in `lesson`.
    `numbers`: the entries that this exhibit covers in the list of beginners' mistakes.
    """

    lesson: str
    numbers: tuple[int, ...]
    symptom: str
    shows: str
    cell: str
    cause: str
    fix: str


@dataclass(frozen=True)
class Term:
    """One technical term, and the lesson that introduces it."""

    lesson: str
    name: str
    meaning: str


@dataclass(frozen=True)
class Museum:
    """All exhibits and terms, in lesson order."""

    exhibits: tuple[Exhibit, ...]
    terms: tuple[Term, ...]

    def exhibit_for(self, text: str) -> Exhibit | None:
        """Return the exhibit whose `shows` occurs in `text` (the longest match wins), or None if there is no match."""
        fits = [one for one in self.exhibits if len(one.shows) >= SHORTEST_SYMPTOM_TEXT and one.shows in text]
        return max(fits, key=lambda one: len(one.shows), default=None)


def museum_folder(course: Path) -> Path:
    """Return the folder with the museum's files."""
    return course / "notebooks" / "sources" / "museum"


def load_museum(course: Path) -> Museum:
    """Read all museum files. Raises BrokenMuseum if one is malformed or incomplete."""
    exhibits: list[Exhibit] = []
    terms: list[Term] = []
    for path in sorted(museum_folder(course).glob("*.toml")):
        try:
            data = tomllib.loads(path.read_text(encoding="utf-8"))
            exhibits += [_exhibit(path.stem, entry) for entry in data.get("mistake", [])]
            terms += [Term(path.stem, entry["name"], entry["meaning"]) for entry in data.get("term", [])]
        except (tomllib.TOMLDecodeError, KeyError, TypeError) as error:
            raise BrokenMuseum(f"{path.name}: {error!r}") from error
    return Museum(tuple(exhibits), tuple(terms))


def _exhibit(lesson: str, entry: dict[str, Any]) -> Exhibit:
    return Exhibit(
        lesson=lesson,
        numbers=tuple(entry["numbers"]),
        symptom=entry["symptom"],
        shows=entry["shows"],
        cell=entry["cell"],
        cause=entry["cause"],
        fix=entry["fix"],
    )
