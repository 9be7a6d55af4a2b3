"""Grade one Gradescope submission, and write results.json even if grading fails."""

import json
from pathlib import Path
from typing import Any

from workbook.exercise.definition import Exercise
from workbook.grading.exports import gradescope
from workbook.grading.files import write_whole
from workbook.grading.hand_ins import hand_in_below
from workbook.grading.results import Result
from workbook.grading.single import choose_isolation, grade_one
from workbook.isolation.tiers import IN_SHORT
from workbook.recording.codec import encode
from workbook.recording.plain_text import without_commands

FAULT = (
    "infra_error: this submission was not judged because of an error in the judge, not in the program ({reason}). "
    "It has no score, so no points are lost. Submit again, or ask your instructor to run the autograder again."
)


def results_json(result: Result) -> str:
    """Return the content of Gradescope's results.json, which must have a score at the top level or in a test.

    An answer that can't be judged (no file, two files, an empty file) is reported as a single failed test. The test's
    output gives the reason, so that the student can fix the problem and submit again. After an error in the judge,
    there's no score at all, so the student doesn't lose any points.
    """
    data: dict[str, Any] = json.loads(gradescope(result))
    if result.status == "infra_error":
        data |= {"output": FAULT.format(reason=result.reason), "tests": []}
    elif result.status == "ungradable":
        data["output"] = f"{result.exercise}: not judged, because {result.reason}."
        data["tests"] = [_unjudged(result)]
    data["extra_data"]["versions"] = encode(result.versions)
    tier = result.isolation
    ran = f"Isolation: {tier} (the program ran {IN_SHORT[tier]}). {result.isolation_problem}".strip()
    said = [data["output"], result.tried_twice(), ran]
    data["output"] = without_commands("\n".join(filter(None, said)))
    return json.dumps(data, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def _unjudged(result: Result) -> dict[str, Any]:
    return {
        "name": "There is one program that can be judged",
        "name_format": "text",
        "number": "1",
        "score": 0.0,
        "max_score": result.max_score,
        "status": "failed",
        "output": f"{without_commands(str(result.reason))}\nSubmit again: one .py or .ipynb file with your answer.",
        "output_format": "text",
        "visibility": "visible",
    }


def fault_json(reason: str) -> str:
    """Return the content of results.json for a submission that couldn't be judged because our own code failed."""
    data = {
        "output": without_commands(FAULT.format(reason=reason)),
        "output_format": "text",
        "stdout_visibility": "hidden",
        "extra_data": {"status": "infra_error"},
        "tests": [],
    }
    return json.dumps(data, indent=1, ensure_ascii=False) + "\n"


def grade_submission(exercise: Exercise, submission: Path, results: Path, isolation: str) -> Result:
    """Judge the answer in the folder `submission`, and write the file `results`. Raises NoSandbox or OSError."""
    hand_in = hand_in_below("submission", submission, exercise.stem)
    result = grade_one(exercise, hand_in, results.parent, choose_isolation(isolation))
    write_whole(results, results_json(result))
    return result
