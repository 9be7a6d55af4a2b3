"""Define a result, which is one line of `results.jsonl`. All exports are made from results.

These classes are the schema: their fields are stored in this order (see `workbook.recording.codec`). Fields that a
newer version added are kept in `unknown` and written back.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from workbook.criteria.runner import CriterionResult, Status
from workbook.grading.changes import Override
from workbook.recording.codec import NOT_STORED, STORED_IF_SET, UNKNOWN_FIELDS, stored_as
from workbook.recording.plain_text import without_commands
from workbook.recording.recording import Clock

ResultStatus = Literal["graded", "ungradable", "infra_error"]
StudentAndExercise = tuple[str, str]


@dataclass(frozen=True)
class CriterionLine:
    """The result of one criterion, as it's stored."""

    id: str
    title: str
    status: Status
    points: float
    max_points: float
    hidden: bool
    saw: str
    expected: str
    because: str
    try_this: str = field(metadata=stored_as("try"))
    unknown: Mapping[str, Any] = field(default_factory=dict, metadata=UNKNOWN_FIELDS)

    @property
    def is_lost(self) -> bool:
        """Whether the criterion failed completely or in part."""
        return self.status in ("failed", "partial")

    def feedback(self) -> list[str]:
        """Return the criterion's feedback, one line per part: saw, expected, because, try."""
        lines = (("expected", self.expected), ("because", self.because), ("try", self.try_this))
        told = [f"saw: {self.saw}", *(f"{word}: {text}" for word, text in lines if text)]
        return [without_commands(line) for line in told]


@dataclass(frozen=True)
class ProcessSummary:
    """How the program exited, and the beginning of its log. `unfiltered`: see `ProcessRecord`."""

    exit: int | None
    signal: str | None
    limits_hit: tuple[str, ...]
    log: str
    unknown: Mapping[str, Any] = field(default_factory=dict, metadata=UNKNOWN_FIELDS)
    unfiltered: str = field(default="", metadata=STORED_IF_SET)


@dataclass(frozen=True)
class Versions:
    """The versions with which a result was made. `criteria`: SHA-256 of the criteria's files and the driver."""

    workbook: str
    criteria: str
    rclpy: str
    python: str = ""
    unknown: Mapping[str, Any] = field(default_factory=dict, metadata=UNKNOWN_FIELDS)

    def description(self) -> str:
        """Return a short description of the versions, with the beginning of the criteria's hash."""
        return f"workbook {self.workbook}, criteria {self.criteria[:12]}, rclpy {self.rclpy}"


@dataclass(frozen=True)
class Try:
    """One judgment of an answer that was judged more than once. `counts`: whether this judgment became the result.

    `end_only`: whether only the criteria about the program's exit are inconclusive.
    """

    counts: bool
    inconclusive_reason: str = field(metadata=stored_as("doubt"))
    status: ResultStatus
    reason: str | None
    score: float | None
    criteria: tuple[CriterionLine, ...]
    recording: str | None
    clock: Clock | None
    wall_s: float | None
    end_only: bool = False
    unknown: Mapping[str, Any] = field(default_factory=dict, metadata=UNKNOWN_FIELDS)


@dataclass(frozen=True)
class Result:
    """The result for one answer.

    `score` is None unless the answer was graded, so an error in the judge never counts as zero. `answer`: the path of
    the file as it was handed in. `recording`: the recording's path, relative to the folder with the results. `tries`:
    all judgments of an answer that was judged more than once, because the first judgment was inconclusive
    (`inconclusive_reason`). `why_this_try`: a sentence that says which try counts and why. `late_points` and `by_hand`
    aren't stored: the late penalty, which has been subtracted from `score`, and the changes that a person made.
    """

    student: str
    answer: str
    answer_sha256: str
    submitted_at: str | None
    exercise: str
    attempt: int
    status: ResultStatus
    reason: str | None
    score: float | None
    max_score: float
    criteria: tuple[CriterionLine, ...]
    process: ProcessSummary | None
    recording: str | None
    clock: Clock | None
    watched_s: float | None = field(metadata=stored_as("robot_s"))
    wall_s: float | None
    isolation: str
    versions: Versions
    inconclusive_reason: str = field(default="", metadata=stored_as("doubt"))
    tries: tuple[Try, ...] = ()
    why_this_try: str = ""
    late_points: float = field(default=0.0, metadata=NOT_STORED)
    by_hand: tuple[Override, ...] = field(default=(), metadata=NOT_STORED)
    unknown: Mapping[str, Any] = field(default_factory=dict, metadata=UNKNOWN_FIELDS)

    @property
    def key(self) -> StudentAndExercise:
        """The student and the exercise. For each key, only the last result counts."""
        return self.student, self.exercise

    @property
    def tries_differ(self) -> bool:
        """Whether the answer was judged more than once and got different scores."""
        return len({_described(one) for one in self.tries}) > 1

    @property
    def isolation_problem(self) -> str:
        """A sentence about protection that the isolation tier couldn't provide, or "" if nothing was missing."""
        problem = "" if self.process is None else self.process.unfiltered
        return f"Its system calls were not filtered: {problem}." if problem else ""

    def changed_by_hand(self) -> str:
        """Describe the changes that a person made to the result, with the reasons, or return "" if there are none."""
        return " ".join(one.description() for one in self.by_hand)

    def tried_twice(self) -> str:
        """Describe the results of all tries in a few sentences, or return "" if the answer was judged only once."""
        if len(self.tries) < 2:
            return ""
        often = "twice" if len(self.tries) == 2 else f"{len(self.tries)} times"
        told = ", then ".join(map(_described, self.tries))
        kept = f" {self.why_this_try}" if self.why_this_try else ""
        second = " So was the second." if self.tries[1].inconclusive_reason else ""
        reason = self.tries[0].inconclusive_reason
        return f"Tried {often}: {told}.{kept} The first try was inconclusive ({reason}).{second}"


def _described(one: Try) -> str:
    return "not judged" if one.score is None else f"{one.score:g} points"


def criterion_line(judged: CriterionResult) -> CriterionLine:
    """Convert a criterion's result to the form in which it's stored."""
    return CriterionLine(
        id=judged.id,
        title=judged.title,
        status=judged.status,
        points=judged.points,
        max_points=judged.max_points,
        hidden=judged.hidden,
        saw=judged.saw,
        expected=judged.expected,
        because=judged.because,
        try_this=judged.try_this,
    )


def criterion_result(line: CriterionLine) -> CriterionResult:
    """Convert a criterion's result back from the form in which it's stored."""
    return CriterionResult(
        id=line.id,
        title=line.title,
        status=line.status,
        points=line.points,
        max_points=line.max_points,
        hidden=line.hidden,
        saw=line.saw,
        expected=line.expected,
        because=line.because,
        try_this=line.try_this,
    )
