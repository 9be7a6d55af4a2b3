"""Read an exercise source's header: YAML between two ``# ---`` lines, checked field by field."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from workbook.exercise.percent_script import Line, SourceError

KINDS = ("program", "function", "test", "static")
CLOCKS = ("simulated", "wall")
FIELDS = (
    "exercise", "title", "minutes", "difficulty", "kind", "clock", "objectives", "out_of_scope",
)  # fmt: skip
SOLUTION, LEFT_OUT = "solution", "left out"
"""A header field and its only value.

It says that this edition of the course contains the starter instead of the solution.
"""

Header = dict[str, tuple[int, Any]]
"""Maps each field to its line number and value."""


def split_header(path: Path, lines: list[Line]) -> tuple[Header, list[Line]]:
    """Return the header's fields, and the lines after it. Raises SourceError if the header is malformed."""
    if not lines or lines[0][1].rstrip() != "# ---":
        raise SourceError(path, 1, "must begin with a header between two '# ---' lines")
    end = next((i for i, (_, text) in enumerate(lines[1:], start=1) if text.rstrip() == "# ---"), None)
    if end is None:
        raise SourceError(path, 1, "the header has no closing '# ---' line")
    header = _parsed(path, lines[1:end])
    missing = [name for name in FIELDS if name not in header]
    if missing:
        raise SourceError(path, lines[end][0], f"the header lacks {', '.join(missing)}")
    return header, lines[end + 1 :]


def _parsed(path: Path, lines: list[Line]) -> Header:
    plain = []
    for number, text in lines:
        if not text.startswith("#"):
            raise SourceError(path, number, "each header line must begin with '# '")
        plain.append(text[2:] if text.startswith("# ") else text[1:])
    try:
        node = yaml.compose("\n".join(plain), Loader=yaml.SafeLoader)
    except yaml.MarkedYAMLError as error:
        mark = error.context_mark or error.problem_mark
        line = mark.line + 2 if mark else 2
        raise SourceError(path, line, f"the header is not valid YAML: {error.problem}") from error
    if not isinstance(node, yaml.MappingNode):
        raise SourceError(path, 2, "the header must be 'name: value' lines")
    loader = yaml.SafeLoader("")
    header: Header = {}
    for key, value in node.value:
        line = key.start_mark.line + 2
        if key.value not in (*FIELDS, SOLUTION):
            raise SourceError(
                path, line, f"unknown header field {key.value!r}: there are {', '.join(FIELDS)}"
            )
        if key.value in header:
            raise SourceError(path, line, f"the header names {key.value!r} twice")
        header[key.value] = (line, loader.construct_object(value, deep=True))
    return header


def typed_fields(path: Path, header: Header) -> dict[str, Any]:
    """Return the header's values by field, as `ExerciseSource` declares them, without the exercise's name.

    Raises SourceError if a value has the wrong type, or the exercise's name differs from the file's.
    """
    line, stem = header["exercise"]
    if stem != path.stem:
        raise SourceError(path, line, f"exercise says {stem!r}, but the file is called {path.name}")
    fields = _Fields(path, header)
    if SOLUTION in header:
        fields.one_of(SOLUTION, (LEFT_OUT,))
    return {
        "has_solution": SOLUTION not in header,
        "title": fields.text("title"),
        "minutes": fields.whole("minutes", 1, 240),
        "difficulty": fields.whole("difficulty", 1, 5),
        "kind": fields.one_of("kind", KINDS),
        "clock": fields.one_of("clock", CLOCKS),
        "objectives": fields.several("objectives"),
        "out_of_scope": fields.several("out_of_scope"),
    }


@dataclass(frozen=True)
class _Fields:
    """Typed access to a header's fields. Each method raises SourceError for a value of the wrong type."""

    path: Path
    header: Header

    def text(self, name: str) -> str:
        line, value = self.header[name]
        if not isinstance(value, str) or not value.strip():
            raise SourceError(self.path, line, f"{name} must be some text, not {value!r}")
        return value.strip()

    def whole(self, name: str, low: int, high: int) -> int:
        line, value = self.header[name]
        if not isinstance(value, int) or isinstance(value, bool) or not low <= value <= high:
            raise SourceError(
                self.path, line, f"{name} must be a whole number from {low} to {high}, not {value!r}"
            )
        return value

    def one_of(self, name: str, choices: tuple[str, ...]) -> str:
        line, value = self.header[name]
        if value not in choices:
            raise SourceError(self.path, line, f"{name} must be one of {', '.join(choices)}, not {value!r}")
        return str(value)

    def several(self, name: str) -> tuple[str, ...]:
        line, value = self.header[name]
        if (
            not isinstance(value, list)
            or not value
            or not all(isinstance(v, str) and v.strip() for v in value)
        ):
            raise SourceError(self.path, line, f"{name} must be a list of at least one text, not {value!r}")
        return tuple(v.strip() for v in value)
