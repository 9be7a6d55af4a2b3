"""A mark that a person changed, as it is kept and as a result tells of it."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from workbook.recording.codec import NOT_STORED, UNKNOWN_FIELDS


@dataclass(frozen=True)
class Override:
    """One change: `who` gave a student's answer `points` for a criterion, and why. None takes an earlier one back.

    `answer_sha256`: of the answer that it was made for; another answer is judged as ever. `before` and `title` are what
    the result had before, and are not stored.
    """

    student: str
    exercise: str
    criterion: str
    points: float | None
    reason: str
    who: str
    answer_sha256: str
    before: float | None = field(default=None, metadata=NOT_STORED)
    title: str = field(default="", metadata=NOT_STORED)
    unknown: Mapping[str, Any] = field(default_factory=dict, metadata=UNKNOWN_FIELDS)

    @property
    def key(self) -> tuple[str, str, str]:
        """What is changed: the last change of it counts."""
        return self.student, self.exercise, self.criterion

    def told(self) -> str:
        """The change as a sentence for the student."""
        before = "not graded" if self.before is None else f"{self.before:g}"
        points = 0.0 if self.points is None else self.points
        return f"Changed by {self.who}: {self.title}, from {before} to {points:g} points. {self.reason}"
