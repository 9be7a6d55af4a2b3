"""Makes the notebook of an exercise from its source, with the starter or with the solution in it."""

from dataclasses import replace
from typing import Any

import nbformat

from workbook.authoring.document import Cell, Document, as_notebook, with_ids
from workbook.authoring.tree import AuthoringError, Tree
from workbook.exercise.answers import ANSWER_MAGIC
from workbook.exercise.definition import BrokenCriteria, Exercise, load_exercise
from workbook.exercise.source import ExerciseSource, SourceError
from workbook.feedback.wording import points

ANSWER_ID = "your-program"
CHECK_ID = "check"


def read_exercise(tree: Tree, stem: str) -> Exercise:
    """Load an exercise with its criteria.

    Raises:
        AuthoringError: its source or its criteria cannot be used.
    """
    try:
        exercise = load_exercise(stem, tree.root)
        exercise.source  # noqa: B018 - reads and checks the file
    except (SourceError, BrokenCriteria) as error:
        raise AuthoringError(str(error).replace(f"{tree.root}/", "")) from error
    return exercise


def starter_document(tree: Tree, exercise: Exercise) -> Document:
    """The notebook that a student gets."""
    return _document(tree, exercise, exercise.source.starter_code)


def solved_notebook(tree: Tree, exercise: Exercise) -> nbformat.NotebookNode:
    """The notebook with the solution as the answer, and full marks as what `%check` must say.

    Only the check cell counts as run: nbval runs all cells and compares this one.
    """
    document = _document(tree, exercise, exercise.source.solution_code)
    notebook = as_notebook(replace(document, workbook=document.workbook | {"compare": "text"}))
    check = next(cell for cell in notebook.cells if cell.id == CHECK_ID)
    check.execution_count = 1
    line = full_marks_line(exercise.max_points)
    check.outputs = [
        nbformat.v4.new_output("execute_result", data={"text/plain": line}, execution_count=1),
    ]
    return notebook


def full_marks_line(max_points: float) -> str:
    """The text form of `%check` when every criterion passes."""
    return f"Full marks: {points(max_points)} of {points(max_points)} points."


def _document(tree: Tree, exercise: Exercise, program: str) -> Document:
    source = exercise.source
    cells = [
        *(Cell("markdown", text) for text in source.story),
        Cell("markdown", _practice(source), "practice"),
        Cell("markdown", _your_program(source), "your-program-text"),
        Cell("code", f"{ANSWER_MAGIC} {source.stem}\n{program.rstrip()}", ANSWER_ID),
        Cell("markdown", _WATCH, "watch-text"),
        Cell("code", source.live, "watch"),
        Cell("code", "%stop", "stop"),
        Cell("markdown", _CHECK, "check-text"),
        Cell("code", "%check", CHECK_ID),
        Cell("markdown", _HINTS, "hint-text"),
        Cell("code", "%hint", "hint"),
        Cell("markdown", _SOLUTION, "solution-text"),
        Cell("code", "%solution", "solution"),
        *(Cell("markdown", text) for text in source.afterword),
        Cell("markdown", _onward(tree, source), "onward"),
    ]
    try:
        named = with_ids(cells)
    except ValueError as error:
        raise AuthoringError(f"solutions/{source.stem}.py: {error}") from error
    metadata: dict[str, Any] = {"exercise": source.stem, "made_from": f"solutions/{source.stem}.py"}
    return Document(named, metadata)


def _practice(source: ExerciseSource) -> str:
    return "**You will practice**\n\n" + "\n".join(f"- {objective}" for objective in source.objectives)


def _your_program(source: ExerciseSource) -> str:
    return (
        "## Your program\n\n"
        "Change the cell below and run it (Shift+Enter). It does not run here: it is saved as "
        f"`answers/{source.stem}.py`, with the version before it kept beside it. Keep its first line; with "
        "` --check` at its end, running the cell also checks it."
    )


_WATCH = (
    "## Watch it run\n\n`%start` runs your program as its own process, on the ROS domain of this notebook. "
    "`%stop` ends it."
)
_CHECK = (
    "## Check it\n\nAs often as you like. It shows what your program did, and the first thing to fix. "
    "In JupyterLab it uses the text that is on the screen, even if you have not run the cell."
)
_HINTS = "## Stuck?\n\nThree hints, one at a time: run the cell again for the next."
_SOLUTION = (
    "## The solution\n\nOpens after your program passes, or after some tries. It also shows other good ways."
)


def _onward(tree: Tree, source: ExerciseSource) -> str:
    lessons = tree.lesson_stems()
    own = [stem for stem in lessons if stem.startswith(f"{source.number:02d}_")]
    later = [stem for stem in lessons if int(stem[:2]) > source.number]
    parts = [f"[Back to lesson {source.number:02d}](../notebooks/{own[0]}.ipynb)"] if own else []
    parts += [f"[On to lesson {later[0][:2]}](../notebooks/{later[0]}.ipynb)"] if later else []
    return " · ".join(parts) if parts else "This exercise stands alone: no lesson follows it yet."
