"""Read ``solutions/NN_slug.py``, a percent script that contains an entire exercise.

The whole file is a runnable program, the reference answer. Its comments contain everything else::

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
    # %% [live]          optional: code for the cell that starts the program, commented out; default `%start`
    # %% [hint]          three times: nudge, pointer, sketch
    # %% [alternatives]  other good solutions, compared

In the answer, each part that the student writes is marked. The lines that replace it in the starter may follow::

        # [solution]
        self.pub = self.create_publisher(String, '/robot/status', 10)
        # [starter]
        # | # TODO 1: create the publisher
        # [end]

In the students' edition, the header contains ``solution: left out``, and the answer is the starter.
"""

import ast
import difflib
import re
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from workbook.exercise.percent_script import Line, SourceCell, cells_of, markdown, trimmed
from workbook.exercise.percent_script import SourceError as SourceError
from workbook.exercise.solution_parts import split_answer
from workbook.exercise.source_header import split_header, typed_fields

STEM = re.compile(r"(?P<number>\d\d)_(?P<slug>[a-z][a-z0-9_]*)")
DEEPER = "_deeper"
"""The end of the stem of an optional notebook that goes deeper than its lesson, such as `01_the_context_deeper`."""
HINT_NAMES = ("nudge", "pointer", "sketch")
DEFAULT_LIVE = "%start"


class UnknownExercise(LookupError):
    """Raised when no exercise has this name. The message lists the existing exercises."""


@dataclass(frozen=True)
class ExerciseSource:
    """One exercise as its author wrote it.

    Strings are Markdown or Python code without a final newline, except that the two programs end with one.
    """

    path: Path
    stem: str
    number: int
    slug: str
    title: str
    minutes: int
    difficulty: int
    """From 1 (a first step) to 5 (needs long thought)."""
    kind: str
    clock: str
    objectives: tuple[str, ...]
    out_of_scope: tuple[str, ...]
    has_solution: bool
    """Whether this edition of the course contains the solution. If not, `solution_code` is the starter."""
    story: tuple[str, ...]
    """Markdown cells before the answer cell."""
    afterword: tuple[str, ...]
    """Markdown cells after the answer cell."""
    live: str
    """Code for the cell that starts the student's program."""
    solution_code: str
    starter_code: str
    hints: tuple[str, str, str]
    alternatives: str


def load(path: Path | str) -> ExerciseSource:
    """Read and check one exercise source.

    Raises SourceError, which says where the problem is and what to write, if something is missing or malformed. Raises
    OSError if the file can't be read.
    """
    path = Path(path)
    named = STEM.fullmatch(path.stem)
    if named is None:
        raise SourceError(path, 1, "the file name must look like 09_joint_positions.py (two digits, _, slug)")
    lines = list(enumerate(path.read_text(encoding="utf-8").splitlines(), start=1))
    header, remaining = split_header(path, lines)
    cells = cells_of(path, remaining)
    answer = _answer_cell(path, cells)
    fields = typed_fields(path, header)
    solution, starter = _programs(path, answer, has_solution=fields["has_solution"])
    story, afterword = _stories(path, cells, answer)
    return ExerciseSource(
        path=path,
        stem=path.stem,
        number=int(named["number"]),
        slug=named["slug"],
        **fields,
        story=story,
        afterword=afterword,
        live=_live(path, cells),
        solution_code=solution,
        starter_code=starter,
        hints=_hints(path, cells, lines[-1][0] if lines else 1),
        alternatives=_alternatives(path, cells, lines[-1][0] if lines else 1),
    )


def driver_of(solution: Path) -> Path | None:
    """Return the path of the driver: the program that calls the functions of an answer to this exercise.

    The result is None if the answer itself is a program.
    """
    driver = solution.parent.parent / "exercises" / "drivers" / solution.name
    return driver if driver.is_file() else None


def partner_of(solution: Path) -> Path | None:
    """Return the path of the partner: the program that runs along with a started answer, or None if there is none."""
    partner = solution.parent.parent / "exercises" / "partners" / solution.name
    return partner if partner.is_file() else None


def stems(solutions: Path | str) -> tuple[str, ...]:
    """Return the stems of all exercises in the folder, in order of their numbers."""
    return tuple(sorted(path.stem for path in Path(solutions).glob("*.py") if STEM.fullmatch(path.stem)))


def find(solutions: Path | str, name: str) -> Path:
    """Return the source of the exercise called ``name``: a stem, a slug, a number, or the name of one of its files.

    Raises UnknownExercise if none or more than one matches.
    """
    known = stems(solutions)
    wanted = Path(name).name.removesuffix(".py").removesuffix(".ipynb")
    fits = [stem for stem in known if wanted in (stem, stem[3:], stem[:2], stem[:2].lstrip("0") or "0")]
    if len(fits) == 1:
        return Path(solutions) / f"{fits[0]}.py"
    if fits:
        raise UnknownExercise(f"{name!r} could be {' or '.join(fits)}: write the complete name")
    if not known:
        raise UnknownExercise(f"no exercise {name!r}: {solutions} has no exercises")
    near = difflib.get_close_matches(wanted, [*known, *(stem[3:] for stem in known)], n=1)
    guess = f" Did you mean {near[0]}?" if near else ""
    raise UnknownExercise(f"no exercise {name!r}.{guess} There are: {', '.join(known)}")


def _answer_cell(path: Path, cells: list[SourceCell]) -> SourceCell:
    answers = [cell for cell in cells if cell.kind == "answer"]
    if len(answers) != 1:
        where = answers[1].line if answers else 1
        raise SourceError(path, where, f"needs exactly one '# %% [answer]' cell, found {len(answers)}")
    return answers[0]


def _programs(path: Path, answer: SourceCell, *, has_solution: bool) -> tuple[str, str]:
    """Return the solution and the starter, both of which must be valid Python."""
    solution, starter = split_answer(trimmed(answer.body), path)
    _must_parse(path, "solution", solution, answer.line)
    _must_parse(path, "starter", starter, answer.line)
    if has_solution and [text for _, text in solution] == [text for _, text in starter]:
        raise SourceError(
            path, answer.line, "the answer marks no [solution] part: the starter gives everything away"
        )
    return _program(solution), _program(starter)


def _stories(
    path: Path, cells: list[SourceCell], answer: SourceCell
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the Markdown cells before the answer, and those after it."""
    stories = [cell for cell in cells if cell.kind == "markdown"]
    before = tuple(markdown(path, cell) for cell in stories if cell.line < answer.line)
    if not before or not before[0].startswith("# "):
        raise SourceError(
            path, answer.line, "a '# %% [markdown]' cell with a '# title' must come before the answer"
        )
    return before, tuple(markdown(path, cell) for cell in stories if cell.line > answer.line)


def _live(path: Path, cells: list[SourceCell]) -> str:
    found = [cell for cell in cells if cell.kind == "live"]
    if len(found) > 1:
        raise SourceError(path, found[1].line, "there is more than one [live] cell")
    return markdown(path, found[0]) if found else DEFAULT_LIVE


def _hints(path: Path, cells: list[SourceCell], last: int) -> tuple[str, str, str]:
    found = [cell for cell in cells if cell.kind == "hint"]
    if len(found) != len(HINT_NAMES):
        where = found[len(HINT_NAMES)].line if len(found) > len(HINT_NAMES) else last
        raise SourceError(
            path, where, f"needs exactly three [hint] cells ({', '.join(HINT_NAMES)}), found {len(found)}"
        )
    nudge, pointer, sketch = (markdown(path, cell) for cell in found)
    return nudge, pointer, sketch


def _alternatives(path: Path, cells: list[SourceCell], last: int) -> str:
    found = [cell for cell in cells if cell.kind == "alternatives"]
    if len(found) != 1:
        where = found[1].line if found else last
        raise SourceError(path, where, f"needs exactly one [alternatives] cell, found {len(found)}")
    return markdown(path, found[0])


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
