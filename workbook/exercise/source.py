"""Reads ``solutions/NN_slug.py``: one percent script that holds everything an exercise is made of.

The whole file is a runnable program, the reference answer. Its comments carry the rest::

    # ---
    # exercise: 09_joint_positions
    # title: The joint positions
    # minutes: 25
    # difficulty: 2
    # kind: program
    # clock: simulated
    # objectives: [publish an array]
    # out_of_scope: [inverse kinematics]
    # ---
    # %% [markdown]      story cells, before or after the answer
    # %% [answer]        the program, with marked parts that the student writes
    # %% [live]          optional: code of the cell that starts the program, commented out; default `%start`
    # %% [hint]          three times: nudge, pointer, sketch
    # %% [alternatives]  other good ways, weighed

In the answer a part that the student writes is marked, and may name the lines that replace it::

        # [solution]
        self.pub = self.create_publisher(String, '/robot/status', 10)
        # [starter]
        # | # TODO 1: create the publisher
        # [end]
"""

import ast
import difflib
import re
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

STEM = re.compile(r"(?P<number>\d\d)_(?P<slug>[a-z][a-z0-9_]*)")
KINDS = ("program", "function", "test", "static")
CLOCKS = ("simulated", "wall")
HINT_NAMES = ("nudge", "pointer", "sketch")
DEFAULT_LIVE = "%start"

_CELL = re.compile(r"# %%(?:\s+\[(?P<kind>[^\]]*)\])?\s*(?P<rest>.*)")
_MARKER = re.compile(r"\s*#\s*\[(?P<name>[a-z]+)\]\s*")
_STARTER_LINE = re.compile(r"(?P<indent>\s*)# \|(?: (?P<text>.*))?")
_FIELDS = (
    "exercise", "title", "minutes", "difficulty", "kind", "clock", "objectives", "out_of_scope",
)  # fmt: skip


class SourceError(ValueError):
    """An exercise source that cannot be used; the message begins with ``file:line``."""

    def __init__(self, path: Path | str, line: int, problem: str) -> None:
        super().__init__(f"{path}:{line}: {problem}")
        self.path = Path(path)
        self.line = line
        self.problem = problem


class UnknownExercise(LookupError):
    """No exercise has this name; the message lists those that exist."""


@dataclass(frozen=True)
class ExerciseSource:
    """One exercise as its author wrote it. Texts are markdown or Python code and end without a newline,
    except the two programs, which end with one."""

    path: Path
    stem: str
    number: int
    slug: str
    title: str
    minutes: int
    difficulty: int
    """1 (a first step) to 5 (a long think)."""
    kind: str
    clock: str
    objectives: tuple[str, ...]
    out_of_scope: tuple[str, ...]
    story: tuple[str, ...]
    """Markdown cells before the answer cell."""
    afterword: tuple[str, ...]
    """Markdown cells after the answer cell."""
    live: str
    """Code of the cell that starts the student's program."""
    solution_code: str
    starter_code: str
    hints: tuple[str, str, str]
    alternatives: str


Line = tuple[int, str]
"""A line of the file with its number, from 1."""


@dataclass(frozen=True)
class _Cell:
    kind: str
    line: int
    body: tuple[Line, ...]


def load(path: Path | str) -> ExerciseSource:
    """Read and check one exercise source.

    Raises:
        SourceError: something is missing or malformed; says where and what to write.
        OSError: the file cannot be read.
    """
    path = Path(path)
    named = STEM.fullmatch(path.stem)
    if named is None:
        raise SourceError(path, 1, "the file name must look like 09_joint_positions.py (two digits, _, slug)")
    lines = list(enumerate(path.read_text(encoding="utf-8").splitlines(), start=1))
    header, rest = _header(path, lines)
    cells = _cells(path, rest)
    answers = [cell for cell in cells if cell.kind == "answer"]
    if len(answers) != 1:
        where = answers[1].line if answers else 1
        raise SourceError(path, where, f"needs exactly one '# %% [answer]' cell, found {len(answers)}")
    answer = answers[0]
    solution, starter = split_answer(_trimmed(answer.body), path)
    _must_parse(path, "solution", solution, answer.line)
    _must_parse(path, "starter", starter, answer.line)
    if [text for _, text in solution] == [text for _, text in starter]:
        raise SourceError(
            path, answer.line, "the answer marks no [solution] part: the starter gives all away"
        )
    stories = [cell for cell in cells if cell.kind == "markdown"]
    story = tuple(_markdown(path, cell) for cell in stories if cell.line < answer.line)
    if not story or not story[0].startswith("# "):
        raise SourceError(
            path, answer.line, "a '# %% [markdown]' cell with a '# title' must come before the answer"
        )
    fields = _fields(path, header)
    return ExerciseSource(
        path=path,
        stem=path.stem,
        number=int(named["number"]),
        slug=named["slug"],
        **fields,
        story=story,
        afterword=tuple(_markdown(path, cell) for cell in stories if cell.line > answer.line),
        live=_live(path, cells),
        solution_code=_program(solution),
        starter_code=_program(starter),
        hints=_hints(path, cells, lines[-1][0] if lines else 1),
        alternatives=_alternatives(path, cells, lines[-1][0] if lines else 1),
    )


def driver_of(solution: Path) -> Path | None:
    """The program that calls the functions of an answer to this exercise; None where the answer is a program itself."""
    driver = solution.parent.parent / "exercises" / "drivers" / solution.name
    return driver if driver.is_file() else None


def stems(solutions: Path | str) -> tuple[str, ...]:
    """The stems of all exercises in the folder, in order of their numbers."""
    return tuple(sorted(path.stem for path in Path(solutions).glob("*.py") if STEM.fullmatch(path.stem)))


def find(solutions: Path | str, name: str) -> Path:
    """The source of the exercise called ``name``: a stem, a slug, a number, or the name of one of its files.

    Raises:
        UnknownExercise: none or more than one fits.
    """
    known = stems(solutions)
    wanted = Path(name).name.removesuffix(".py").removesuffix(".ipynb")
    fits = [stem for stem in known if wanted in (stem, stem[3:], stem[:2], stem[:2].lstrip("0") or "0")]
    if len(fits) == 1:
        return Path(solutions) / f"{fits[0]}.py"
    if fits:
        raise UnknownExercise(f"{name!r} could be {' or '.join(fits)}: write the full name")
    if not known:
        raise UnknownExercise(f"no exercise {name!r}: {solutions} holds no exercises")
    near = difflib.get_close_matches(wanted, [*known, *(stem[3:] for stem in known)], n=1)
    guess = f" Did you mean {near[0]}?" if near else ""
    raise UnknownExercise(f"no exercise {name!r}.{guess} There are: {', '.join(known)}")


def split_answer(lines: Sequence[Line], path: Path | str = "answer") -> tuple[list[Line], list[Line]]:
    """Split numbered lines of an answer into those of the solution and those of the starter.

    Lines outside of marked parts go to both, unchanged.

    Raises:
        SourceError: markers out of order, left open or misspelled, or a starter line without ``# |``.
    """
    solution: list[Line] = []
    starter: list[Line] = []
    state, opened = "outside", 0
    for number, text in lines:
        found = _MARKER.fullmatch(text)
        name = found["name"] if found else None
        if name is not None:
            if name not in ("solution", "starter", "end"):
                raise SourceError(
                    path, number, f"unknown marker [{name}]: there are [solution], [starter] and [end]"
                )
            if name == "solution" and state != "outside":
                raise SourceError(
                    path, number, f"[solution] inside the part that line {opened} opened: write [end] first"
                )
            if name == "starter" and state != "solution":
                raise SourceError(path, number, "[starter] without a [solution] before it")
            if name == "end" and state == "outside":
                raise SourceError(path, number, "[end] without a [solution] before it")
            if name == "solution":
                opened = number
            state = "outside" if name == "end" else name
        elif state == "outside":
            solution.append((number, text))
            starter.append((number, text))
        elif state == "solution":
            solution.append((number, text))
        else:
            line = _STARTER_LINE.fullmatch(text)
            if line is None:
                raise SourceError(
                    path, number, "a starter line must look like '# | code' (or '# |' when empty)"
                )
            code = line["text"] or ""
            starter.append((number, line["indent"] + code if code else ""))
    if state != "outside":
        raise SourceError(path, opened, "this [solution] has no [end]")
    return solution, starter


def _header(path: Path, lines: list[Line]) -> tuple[dict[str, tuple[int, Any]], list[Line]]:
    if not lines or lines[0][1].rstrip() != "# ---":
        raise SourceError(path, 1, "must begin with a header between two '# ---' lines")
    end = next((i for i, (_, text) in enumerate(lines[1:], start=1) if text.rstrip() == "# ---"), None)
    if end is None:
        raise SourceError(path, 1, "the header has no closing '# ---' line")
    plain = []
    for number, text in lines[1:end]:
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
    header: dict[str, tuple[int, Any]] = {}
    for key, value in node.value:
        line = key.start_mark.line + 2
        if key.value not in _FIELDS:
            raise SourceError(
                path, line, f"unknown header field {key.value!r}: there are {', '.join(_FIELDS)}"
            )
        if key.value in header:
            raise SourceError(path, line, f"the header names {key.value!r} twice")
        header[key.value] = (line, loader.construct_object(value, deep=True))
    missing = [name for name in _FIELDS if name not in header]
    if missing:
        raise SourceError(path, lines[end][0], f"the header lacks {', '.join(missing)}")
    return header, lines[end + 1 :]


def _fields(path: Path, header: dict[str, Any]) -> dict[str, Any]:
    def text(name: str) -> str:
        line, value = header[name]
        if not isinstance(value, str) or not value.strip():
            raise SourceError(path, line, f"{name} must be some text, not {value!r}")
        return value.strip()

    def whole(name: str, low: int, high: int) -> int:
        line, value = header[name]
        if not isinstance(value, int) or isinstance(value, bool) or not low <= value <= high:
            raise SourceError(
                path, line, f"{name} must be a whole number from {low} to {high}, not {value!r}"
            )
        return value

    def one_of(name: str, choices: tuple[str, ...]) -> str:
        line, value = header[name]
        if value not in choices:
            raise SourceError(path, line, f"{name} must be one of {', '.join(choices)}, not {value!r}")
        return str(value)

    def several(name: str) -> tuple[str, ...]:
        line, value = header[name]
        if (
            not isinstance(value, list)
            or not value
            or not all(isinstance(v, str) and v.strip() for v in value)
        ):
            raise SourceError(path, line, f"{name} must be a list of at least one text, not {value!r}")
        return tuple(v.strip() for v in value)

    line, stem = header["exercise"]
    if stem != path.stem:
        raise SourceError(path, line, f"exercise says {stem!r}, but the file is called {path.name}")
    return {
        "title": text("title"),
        "minutes": whole("minutes", 1, 240),
        "difficulty": whole("difficulty", 1, 5),
        "kind": one_of("kind", KINDS),
        "clock": one_of("clock", CLOCKS),
        "objectives": several("objectives"),
        "out_of_scope": several("out_of_scope"),
    }


def _cells(path: Path, lines: list[Line]) -> list[_Cell]:
    kinds = ("markdown", "answer", "live", "hint", "alternatives")
    cells: list[_Cell] = []
    open_kind, open_line, body = "", 0, list[Line]()
    for number, text in lines:
        head = _CELL.fullmatch(text)
        if head is None:
            if not open_kind and text.strip():
                raise SourceError(path, number, "this line stands before the first '# %%' cell")
            body.append((number, text))
            continue
        if open_kind:
            cells.append(_Cell(open_kind, open_line, tuple(body)))
        if head["kind"] not in kinds or head["rest"]:
            raise SourceError(
                path,
                number,
                f"unknown cell {text.strip()!r}: there are {', '.join(f'# %% [{k}]' for k in kinds)}",
            )
        open_kind, open_line, body = head["kind"], number, []
    if open_kind:
        cells.append(_Cell(open_kind, open_line, tuple(body)))
    return cells


def _trimmed(body: Sequence[Line]) -> list[Line]:
    kept = list(body)
    while kept and not kept[0][1].strip():
        kept.pop(0)
    while kept and not kept[-1][1].strip():
        kept.pop()
    return kept


def _uncommented(path: Path, cell: _Cell) -> str:
    lines = []
    for number, text in _trimmed(cell.body):
        if text.strip() and not text.startswith("#"):
            raise SourceError(path, number, f"each line of a [{cell.kind}] cell must begin with '# '")
        lines.append(text[2:] if text.startswith("# ") else text[1:])
    return "\n".join(lines).strip("\n")


def _markdown(path: Path, cell: _Cell) -> str:
    text = _uncommented(path, cell)
    if not text.strip():
        raise SourceError(path, cell.line, f"this [{cell.kind}] cell is empty")
    return text


def _live(path: Path, cells: list[_Cell]) -> str:
    found = [cell for cell in cells if cell.kind == "live"]
    if len(found) > 1:
        raise SourceError(path, found[1].line, "there is more than one [live] cell")
    return _markdown(path, found[0]) if found else DEFAULT_LIVE


def _hints(path: Path, cells: list[_Cell], last: int) -> tuple[str, str, str]:
    found = [cell for cell in cells if cell.kind == "hint"]
    if len(found) != len(HINT_NAMES):
        where = found[len(HINT_NAMES)].line if len(found) > len(HINT_NAMES) else last
        raise SourceError(
            path, where, f"needs exactly three [hint] cells ({', '.join(HINT_NAMES)}), found {len(found)}"
        )
    nudge, pointer, sketch = (_markdown(path, cell) for cell in found)
    return nudge, pointer, sketch


def _alternatives(path: Path, cells: list[_Cell], last: int) -> str:
    found = [cell for cell in cells if cell.kind == "alternatives"]
    if len(found) != 1:
        where = found[1].line if found else last
        raise SourceError(path, where, f"needs exactly one [alternatives] cell, found {len(found)}")
    return _markdown(path, found[0])


def _program(lines: Sequence[Line]) -> str:
    return "\n".join(text for _, text in lines) + "\n"


def _must_parse(path: Path, what: str, lines: list[Line], cell_line: int) -> None:
    if not any(text.strip() for _, text in lines):
        raise SourceError(path, cell_line, f"the {what} is empty")
    try:
        ast.parse(_program(lines))
    except SyntaxError as error:
        at = min(max(error.lineno or 1, 1), len(lines)) - 1
        shown = textwrap.shorten(lines[at][1].strip(), 60)
        raise SourceError(
            path, lines[at][0], f"the {what} is not valid Python: {error.msg} ({shown})"
        ) from error
