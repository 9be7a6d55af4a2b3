"""Grade a push to a class repository: write a summary for the run's page, and results in GitHub Classroom's format.

Classroom's reporter (classroom-resources/autograding-grading-reporter) reads one result for each *runner* from a
variable with the runner's name. The result is JSON, encoded as base64. The reporter fails on a result without `tests`.
If tests have different points, it counts the passed tests instead of adding up points. So each criterion has its own
runner, with exactly one test.
"""

import base64
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from workbook.criteria.criterion import Criterion
from workbook.exercise.definition import Exercise
from workbook.feedback.markdown import as_markdown, plain_markup
from workbook.grading.hand_ins import hand_in_below, hand_in_named
from workbook.grading.pages import judgement_of
from workbook.grading.results import CriterionLine, Result
from workbook.grading.single import grade_one
from workbook.isolation.tiers import IN_SHORT, Isolation
from workbook.recording.plain_text import without_commands
from workbook.templating import as_markup, render

LONGEST_MESSAGE = 1_000
WHOSE = "the pushed answer"
NOTHING = "Nothing is handed in for this exercise yet."


@dataclass(frozen=True)
class Pushed:
    """The result of one exercise. `result` is None if the student didn't hand in an answer to it."""

    exercise: Exercise
    result: Result | None


def grade_pushed(
    exercises: Sequence[Exercise], folder: Path, out: Path, isolation: Isolation
) -> tuple[Pushed, ...]:
    """Judge the answers in a student's folder, one exercise after another. Store recordings under `out`."""
    found = []
    for exercise in exercises:
        hand_in = hand_in_named(WHOSE, folder, exercise.stem)
        if hand_in is None and len(exercises) == 1:  # like `grade`, we accept a single answer under any name
            only = hand_in_below(WHOSE, folder / "answers", exercise.stem)
            hand_in = only if only.problem is None else None
        result = None if hand_in is None else grade_one(exercise, hand_in, out, isolation)
        found.append(Pushed(exercise, result))
    return tuple(found)


# --- Classroom ------------------------------------------------------------------------------------------------------


def runners(exercise: Exercise) -> dict[str, Criterion]:
    """Return the criteria that carry points, keyed by runner name. Runner names consist of letters and digits."""
    worth = [criterion for criterion in exercise.criteria if criterion.points > 0]
    return {f"e{exercise.stem[:2]}c{number}": criterion for number, criterion in enumerate(worth, start=1)}


def classroom(pushed: Pushed) -> dict[str, dict[str, Any]]:
    """Return Classroom's JSON for each runner of an exercise."""
    result = pushed.result
    if result is None:
        return {name: _one(one, "fail", 0.0, NOTHING) for name, one in runners(pushed.exercise).items()}
    if result.status != "graded":
        status = "error" if result.status == "infra_error" else "fail"
        told = f"Not judged: {result.reason}"
        return {name: _one(one, status, 0.0, told) for name, one in runners(pushed.exercise).items()}
    judged = {one.id: one for one in result.criteria}
    return {name: _judged(one, judged[one.id]) for name, one in runners(pushed.exercise).items()}


def not_run(criterion: Criterion) -> dict[str, Any]:
    """Return Classroom's JSON for a criterion that has no result because the judge didn't finish."""
    return _one(criterion, "error", 0.0, "The judge did not finish. This is not the program's fault.")


def encoded(result: Mapping[str, Any]) -> str:
    """Encode a result as base64 for the variable that Classroom's reporter reads."""
    return base64.b64encode(json.dumps(result, ensure_ascii=True, allow_nan=False).encode()).decode()


def _judged(criterion: Criterion, one: CriterionLine) -> dict[str, Any]:
    told = "" if criterion.hidden else "\n".join(one.feedback())
    return _one(criterion, "pass" if one.status == "passed" else "fail", one.points, told)


def _one(criterion: Criterion, status: str, score: float, message: str) -> dict[str, Any]:
    test = {
        "name": "A criterion that is not shown" if criterion.hidden else criterion.title,
        "status": status,
        "score": score,
        "message": without_commands(message)[:LONGEST_MESSAGE],
        "test_code": "",
        "filename": "",
        "line_no": 0,
        "duration": 0,
    }
    return {"version": 3, "status": status, "max_score": criterion.points, "tests": [test]}


# --- the page of a run ----------------------------------------------------------------------------------------------


def summary(pushed: Sequence[Pushed], out: Path, isolation: Isolation) -> str:
    """Render a run's summary as Markdown: an overview of the points, and then a feedback card for each answer."""
    return render(
        "grading/run_summary",
        pushed=pushed,
        nothing=NOTHING,
        plain=plain_markup,
        points=_points,
        card=lambda result: as_markup(as_markdown(judgement_of(result, out))),
        isolation=isolation,
        tier=IN_SHORT[isolation],
    )


def _points(one: Pushed) -> str:
    if one.result is None:
        return "nothing handed in"
    if one.result.score is None:
        return "not judged"
    shown = [each for each in one.result.criteria if not each.hidden]
    return f"{sum(each.points for each in shown):g} of {sum(each.max_points for each in shown):g}"


def all_hold(pushed: Sequence[Pushed]) -> bool:
    """Return whether something was handed in and each answer passed all criteria that aren't hidden."""
    return any(one.result is not None for one in pushed) and all(
        one.result is None
        or (
            one.result.status == "graded"
            and all(each.status == "passed" for each in one.result.criteria if not each.hidden)
        )
        for one in pushed
    )
