"""The error museum: what goes wrong in which lesson, with its cause and its fix; and the terms of each lesson.

The data is `notebooks/sources/museum/NN_slug.toml`, one file a lesson. Pages and feedback are made from it.
"""

import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

SHORTEST_SYMPTOM_TEXT = 12
"""Characters. A shorter text occurs in too many outputs to identify an error."""


class BrokenMuseum(ValueError):
    """A file of the museum cannot be used. The message says where and why."""


@dataclass(frozen=True)
class Exhibit:
    """One thing that goes wrong: `symptom` as a student meets it, `shows` as the cell `cell` of `lesson` prints it.

    `numbers`: which entries of the list of beginners' mistakes it stands for.
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
    """One word of the field, and the lesson that introduces it."""

    lesson: str
    name: str
    meaning: str


@dataclass(frozen=True)
class Museum:
    """All exhibits and terms, in the order of the lessons."""

    exhibits: tuple[Exhibit, ...]
    terms: tuple[Term, ...]

    def exhibit_for(self, text: str) -> Exhibit | None:
        """The exhibit whose `shows` occurs in `text`; the longest one wins. None when there is none."""
        fits = [one for one in self.exhibits if len(one.shows) >= SHORTEST_SYMPTOM_TEXT and one.shows in text]
        return max(fits, key=lambda one: len(one.shows), default=None)


def museum_folder(course: Path) -> Path:
    """Where the files of the museum are."""
    return course / "notebooks" / "sources" / "museum"


def load_museum(course: Path) -> Museum:
    """Read all files. Raises BrokenMuseum when one is damaged or lacks something."""
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
