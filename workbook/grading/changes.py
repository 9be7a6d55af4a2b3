"""Define `Override`, a person's change to a mark, as it's stored in overrides.jsonl and described in a result."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from workbook.recording.codec import NOT_STORED, UNKNOWN_FIELDS


@dataclass(frozen=True)
class Override:
    """A change to a mark: `who` gave an answer `points` for a criterion and stated a `reason`.

    `points` is None if this change undoes an earlier one. `answer_sha256` identifies the only answer to which the
    change applies. `before` (the points before the change) and `title` come from the result and aren't stored.
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
        """The student, exercise, and criterion. For each key, only the last change counts."""
        return self.student, self.exercise, self.criterion

    def description(self) -> str:
        """Describe the change to the student in a sentence."""
        before = "not graded" if self.before is None else f"{self.before:g}"
        points = 0.0 if self.points is None else self.points
        return f"Changed by {self.who}: {self.title}, from {before} to {points:g} points. {self.reason}"
