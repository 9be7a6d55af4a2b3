"""Generate an exercise's notebook from its source, with either the starter or the solution in it."""

from dataclasses import replace
from typing import Any

import nbformat

from workbook.authoring.document import Cell, Document, as_notebook, with_ids
from workbook.authoring.tree import AuthoringError, Tree
from workbook.exercise.answers import ANSWER_MAGIC
from workbook.exercise.definition import BrokenCriteria, Exercise, load_exercise
from workbook.exercise.source import ExerciseSource, SourceError, partner_of
from workbook.feedback.wording import points

ANSWER_ID = "your-program"
CHECK_ID = "check"


def read_exercise(tree: Tree, stem: str) -> Exercise:
    """Load an exercise with its criteria.

    Raises:
        AuthoringError: the source or the criteria are invalid.
    """
    try:
        exercise = load_exercise(stem, tree.root)
        exercise.source  # noqa: B018 - reads and checks the file
    except (SourceError, BrokenCriteria) as error:
        raise AuthoringError(str(error).replace(f"{tree.root}/", "")) from error
    return exercise


def starter_document(tree: Tree, exercise: Exercise) -> Document:
    """Return the notebook that students get, with the starter in the answer cell."""
    return _document(tree, exercise, exercise.source.starter_code)


def solved_notebook(tree: Tree, exercise: Exercise) -> nbformat.NotebookNode:
    """Return the notebook with the solution as the answer, and full marks as the expected output of `%check`.

    Only the check cell is marked as executed, because nbval compares only executed cells, although it runs all of them.
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
    """Return the text that `%check` prints when every criterion passes."""
    return f"Full marks: {points(max_points)} of {points(max_points)} points."


def _document(tree: Tree, exercise: Exercise, program: str) -> Document:
    source = exercise.source
    cells = [
        *(Cell("markdown", text) for text in source.story),
        Cell("markdown", _practice(source), "practice"),
        Cell("markdown", _your_program(source), "your-program-text"),
        Cell("code", f"{ANSWER_MAGIC} {source.stem}\n{program.rstrip()}", ANSWER_ID),
        Cell("markdown", _watch(source), "watch-text"),
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
        "Edit the cell below, and run it with Shift+Enter. Running the cell doesn't start your program yet. Instead, "
        f"it saves the program as `answers/{source.stem}.py` and keeps a backup of the previous version in the same "
        "folder. Don't remove the cell's first line. If you add ` --check` to the end of that line, running the cell "
        "also checks your program."
    )


def _watch(source: ExerciseSource) -> str:
    others, publishers = "", "your program"
    if partner_of(source.path) is not None:
        others = (
            "It also starts the robot's other nodes, so that your node has something to communicate with. "
        )
        publishers = "all these nodes"
    return (
        "## Watch it run\n\n`%start` runs your program in its own process, in this notebook's ROS domain. "
        f"{others}Below the cell and in the robot panel, you'll see a robot that reacts to the messages from "
        f"{publishers}. `%stop` ends the program."
    )


_CHECK = (
    "## Check it\n\nCheck your program as often as you like. You'll see what it did, and what to fix first. "
    "In JupyterLab, `%check` uses the program as it stands in the cell above, even if you haven't run that cell."
)
_HINTS = "## Stuck?\n\nThere are three hints. Each time you run the cell below, it shows the next one."
_SOLUTION = (
    "## The solution\n\nYou can see the solution once your program has passed, or after several tries. "
    "Below the solution, you'll find other good ways to solve the exercise."
)


def _onward(tree: Tree, source: ExerciseSource) -> str:
    lessons = tree.lesson_stems()
    own = [stem for stem in lessons if stem.startswith(f"{source.number:02d}_")]
    later = [stem for stem in lessons if int(stem[:2]) > source.number]
    parts = [f"[Back to lesson {source.number:02d}](../notebooks/{own[0]}.ipynb)"] if own else []
    parts += [f"[On to lesson {later[0][:2]}](../notebooks/{later[0]}.ipynb)"] if later else []
    return " · ".join(parts) if parts else "This exercise stands alone: no lesson follows it yet."
