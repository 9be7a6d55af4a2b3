"""pytest plugin: one test per criterion of an answer, or of a stored recording.

    pytest exercises/criteria/09_joint_positions.py --answer my_answer.py
    pytest exercises/criteria/09_joint_positions.py --recording recording.json

The functions are the very ones that grade; pytest only runs and shows them.
"""

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from workbook.criteria.runner import CriterionResult

MOST_TRIES = 3
"""As in a grading run: what a busy machine left in doubt is judged again."""


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add `--answer`, `--recording`, and `--seed`."""
    group = parser.getgroup("rclpy-workbook")
    group.addoption("--answer", type=Path, help="run this answer and judge it by the criteria file given")
    group.addoption("--recording", type=Path, help="judge this stored recording by the criteria file given")
    group.addoption(
        "--seed", type=int, help="draw what the judge sends from this number, as in an earlier run"
    )


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> "CriteriaFile | None":
    """Collect a criteria file when one of the options is given."""
    config = parent.config
    if file_path.suffix != ".py" or file_path.parent.name != "criteria":
        return None
    if config.getoption("--answer", None) is None and config.getoption("--recording", None) is None:
        return None
    return CriteriaFile.from_parent(parent, path=file_path)


class CriteriaFile(pytest.File):
    """A criteria file; its tests are the criteria."""

    def collect(self) -> Iterator["CriterionItem"]:
        """One item per criterion of the exercise."""
        from workbook.exercise.definition import load_exercise

        exercise = load_exercise(self.path.stem, self.path.parents[2])
        for criterion in exercise.criteria:
            yield CriterionItem.from_parent(self, name=criterion.id)

    def results(self) -> dict[str, "CriterionResult"]:
        """Results by criterion, from one watch of the answer however many tests ask."""
        if not hasattr(self, "_results"):
            self._results = {result.id: result for result in self._judge()}
        return self._results

    def _judge(self) -> tuple["CriterionResult", ...]:
        from workbook.exercise.answers import read_answer
        from workbook.exercise.definition import load_exercise
        from workbook.exercise.judgement import judge_recording
        from workbook.exercise.judging import Judge
        from workbook.recording.recording import Recording
        from workbook.watching.observer import Observer

        exercise = load_exercise(self.path.stem, self.path.parents[2])
        stored = self.config.getoption("--recording", None)
        if stored is not None:
            judgement = judge_recording(exercise, "", Recording.load(stored))
        else:
            answer = read_answer(self.config.getoption("--answer"), exercise.stem)
            seed = self.config.getoption("--seed", None)
            for _ in range(MOST_TRIES):
                with Observer() as observer:
                    judgement = Judge(observer).judge(exercise, answer, thorough=True, seed=seed)
                if not judgement.doubt:
                    break
        if judgement.status != "graded":
            raise RuntimeError(judgement.reason)
        return judgement.criteria


class CriterionFailed(AssertionError):
    """A criterion that is not met; its text is the feedback, with the id of the cause."""


class CriterionItem(pytest.Item):
    """One criterion as a test."""

    def runtest(self) -> None:
        """Pass, skip or fail as the criterion did."""
        assert isinstance(self.parent, CriteriaFile)
        result = self.parent.results()[self.name]
        if result.status == "skipped":
            pytest.skip(result.saw)
        if result.status != "passed":
            raise CriterionFailed(
                f"cause: {result.cause}\nsaw: {result.saw}\nexpected: {result.expected}\n"
                f"because: {result.because}\ntry: {result.try_this}"
            )

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> str:
        """The feedback of a failed criterion; anything else as pytest shows it."""
        if isinstance(excinfo.value, CriterionFailed):
            return str(excinfo.value)
        return str(super().repr_failure(excinfo, style))

    def reportinfo(self) -> tuple[Path, None, str]:
        """The criteria file and the criterion's id."""
        return self.path, None, self.name
