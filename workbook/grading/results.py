"""What a result holds: one line of `results.jsonl`, the one truth that every export is made from.

These classes are the schema: their fields, in this order, are what is stored (see `workbook.recording.codec`).
Fields of a newer version are kept in `unknown`, and written again.
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
    """What one criterion gave."""

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
        """Whether the criterion failed or passed only in part."""
        return self.status in ("failed", "partial")

    def told(self) -> list[str]:
        """The feedback of the criterion, one part a line: saw, expected, because, try."""
        lines = (("expected", self.expected), ("because", self.because), ("try", self.try_this))
        told = [f"saw: {self.saw}", *(f"{word}: {text}" for word, text in lines if text)]
        return [without_commands(line) for line in told]


@dataclass(frozen=True)
class ProcessSummary:
    """How the program ended, and the beginning of what it printed. `unfiltered`: see `ProcessRecord`."""

    exit: int | None
    signal: str | None
    limits_hit: tuple[str, ...]
    log: str
    unknown: Mapping[str, Any] = field(default_factory=dict, metadata=UNKNOWN_FIELDS)
    unfiltered: str = field(default="", metadata=STORED_IF_SET)


@dataclass(frozen=True)
class Versions:
    """What a result was made with. `criteria`: SHA-256 of all that the exercise is judged by."""

    workbook: str
    criteria: str
    rclpy: str
    python: str = ""
    unknown: Mapping[str, Any] = field(default_factory=dict, metadata=UNKNOWN_FIELDS)

    def told(self) -> str:
        """The versions in a few words; of the criteria, as much as tells them apart."""
        return f"workbook {self.workbook}, criteria {self.criteria[:12]}, rclpy {self.rclpy}"


@dataclass(frozen=True)
class Try:
    """One of the judgements of an answer that was tried more than once. `counts`: whether the result is this one.

    `end_only`: the doubt is about how the program ended, and about nothing else.
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
    """What came out for one answer. `score` is None unless it was graded: an error of ours is never a zero.

    `answer`: the path of the file as it was handed in; `recording`: that of the recording, below the results.
    `tries`: all judgements of an answer that was tried more than once, because the first was inconclusive
    (`inconclusive_reason`); `why_this_try`: which of them counts and why, as a sentence. `late_points`: what lateness
    has taken off `score`; 0 in what is stored. `by_hand`: what a person has changed in it; nothing in what is stored.
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
    simulated_s: float | None = field(metadata=stored_as("robot_s"))
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
        """Whose result this is, and of which exercise: the last one of each counts."""
        return self.student, self.exercise

    @property
    def tries_differ(self) -> bool:
        """Whether the answer was tried more than once and did not always get the same."""
        return len({_told(one) for one in self.tries}) > 1

    @property
    def isolation_problem(self) -> str:
        """What its tier could not do for the program, as a sentence; empty where nothing was missing."""
        problem = "" if self.process is None else self.process.unfiltered
        return f"Its system calls were not filtered: {problem}." if problem else ""

    def changed_by_hand(self) -> str:
        """What a person has changed in it, and why; empty where nothing was changed."""
        return " ".join(one.told() for one in self.by_hand)

    def tried_twice(self) -> str:
        """What all tries gave, as a sentence; empty for an answer that was judged once."""
        if len(self.tries) < 2:
            return ""
        often = "twice" if len(self.tries) == 2 else f"{len(self.tries)} times"
        told = ", then ".join(map(_told, self.tries))
        kept = f" {self.why_this_try}" if self.why_this_try else ""
        second = " So was the second." if self.tries[1].inconclusive_reason else ""
        reason = self.tries[0].inconclusive_reason
        return f"Tried {often}: {told}.{kept} The first try was inconclusive ({reason}).{second}"


def _told(one: Try) -> str:
    return "not judged" if one.score is None else f"{one.score:g} points"


def criterion_line(judged: CriterionResult) -> CriterionLine:
    """What is stored of a judged criterion."""
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
    """A judged criterion, as far as it was stored."""
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
