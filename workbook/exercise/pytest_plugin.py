"""Provide a pytest plugin that turns each criterion into a test, for an answer or a stored recording.

    pytest exercises/criteria/09_joint_positions.py --answer my_answer.py
    pytest exercises/criteria/09_joint_positions.py --recording recording.json

Grading uses the same functions; pytest only runs them and shows the results.
"""

from collections.abc import Iterator
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from workbook.criteria.runner import CriterionResult
    from workbook.exercise.judgement import Judgement


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add `--answer`, `--recording`, and `--seed`."""
    group = parser.getgroup("rclpy-workbook")
    group.addoption("--answer", type=Path, help="run this answer and judge it by the criteria file given")
    group.addoption("--recording", type=Path, help="judge this stored recording by the criteria file given")
    group.addoption(
        "--seed", type=int, help="seed of the random values that the judge sends, as in an earlier run"
    )


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> "CriteriaFile | None":
    """Collect a criteria file if `--answer` or `--recording` is given."""
    config = parent.config
    if file_path.suffix != ".py" or file_path.parent.name != "criteria":
        return None
    if config.getoption("--answer", None) is None and config.getoption("--recording", None) is None:
        return None
    return CriteriaFile.from_parent(parent, path=file_path)


class CriteriaFile(pytest.File):
    """A criteria file, in which each criterion is a test."""

    def collect(self) -> Iterator["CriterionItem"]:
        """Yield one item per criterion of the exercise."""
        from workbook.exercise.definition import load_exercise

        exercise = load_exercise(self.path.stem, self.path.parents[2])
        for criterion in exercise.criteria:
            yield CriterionItem.from_parent(self, name=criterion.id)

    def result(self, criterion: str) -> "CriterionResult":
        """Return a criterion's result.

        Raises RuntimeError if no try of the answer counts, as in `workbook grade`.
        """
        judgement = self._judgement
        if judgement.status != "graded":
            raise RuntimeError(judgement.reason)
        return next(one for one in judgement.criteria if one.id == criterion)

    @cached_property
    def _judgement(self) -> "Judgement":
        """The judgment that counts for the answer or recording. It's computed once for all tests."""
        from workbook.exercise.answers import read_answer
        from workbook.exercise.definition import load_exercise
        from workbook.exercise.judgement import judge_recording
        from workbook.exercise.judging import Judge
        from workbook.exercise.retries import counting, tries_of
        from workbook.recording.recording import Recording
        from workbook.watching.observer import Observer

        exercise = load_exercise(self.path.stem, self.path.parents[2])
        stored = self.config.getoption("--recording", None)
        if stored is not None:
            return judge_recording(exercise, "", Recording.load(stored))
        answer = read_answer(self.config.getoption("--answer"), exercise.stem)
        seed = self.config.getoption("--seed", None)
        with Observer() as observer:
            judge = Judge(observer)
            return counting(tries_of(lambda: judge.judge(exercise, answer, soak=True, seed=seed)))


class CriterionFailed(AssertionError):
    """Raised when a criterion doesn't pass. The message is the feedback, with the cause id."""


class CriterionItem(pytest.Item):
    """One criterion as a test."""

    def runtest(self) -> None:
        """Pass, skip, or fail this test as the criterion did."""
        assert isinstance(self.parent, CriteriaFile)
        result = self.parent.result(self.name)
        if result.status == "skipped":
            pytest.skip(result.saw)
        if result.status != "passed":
            raise CriterionFailed(
                f"cause: {result.cause}\nsaw: {result.saw}\nexpected: {result.expected}\n"
                f"because: {result.because}\ntry: {result.try_this}"
            )

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> str:
        """Return a failed criterion's feedback. For any other exception, return pytest's usual report."""
        if isinstance(excinfo.value, CriterionFailed):
            return str(excinfo.value)
        return str(super().repr_failure(excinfo, style))

    def reportinfo(self) -> tuple[Path, None, str]:
        """Return the criteria file and the criterion's id."""
        return self.path, None, self.name
