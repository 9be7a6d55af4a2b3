"""The outcome of one criterion: words that a student can act on, and a cause id that stays fixed when the words change.

Every verdict that isn't a pass names its cause first: `failed("rate.too-fast", saw, expected, because, try_this)`.

- An id is `word.reason`, both in kebab-case. In the vocabulary, the word is the judging function ("rate",
  "program-runs"); in an exercise, it's the criterion ("results-told.late").
- An id appears exactly once in a file: as the heading of its catalog entry (see `workbook.criteria.rules`), or as a
  literal before its words. Two likely causes need two ids: if `because` differs, so does the id.
- A verdict from the vocabulary keeps its id when an exercise passes it on.

Each wrong answer in the tests names the id that it must get.
"""

import re
from dataclasses import dataclass, replace
from typing import Literal

VerdictStatus = Literal["passed", "failed", "partial", "skipped"]

CAUSE = re.compile(r"[a-z][a-z0-9]*(?:-[a-z0-9]+)*\.[a-z][a-z0-9]*(?:-[a-z0-9]+)*")
"""The format of a cause id, such as "rate.too-fast"."""


@dataclass(frozen=True)
class Verdict:
    """The result of one criterion, and the reason for it.

    `saw` and `expected` are facts, `because` is the likely reason, and `try_this` is one next step. `cause` is the
    reason's id. `share` is the earned part of the points (0 to 1).

    `about_time` marks failures that depend on rates and silences. If such a failure occurs on simulated time, it counts
    only after the program is judged on the wall clock. The exception is a topic named by `pace_of` that provably
    follows simulated time. `recheck_fields` marks values that suggest a wrong type in a message field. The program then
    runs once more with field checks on, to quote their error.

    Raises ValueError if a verdict deducts points but its cause isn't a valid id.
    """

    status: VerdictStatus
    saw: str
    expected: str = ""
    because: str = ""
    try_this: str = ""
    share: float = 0.0
    about_time: bool = False
    recheck_fields: bool = False
    pace_of: str = ""
    cause: str = ""

    def __post_init__(self) -> None:
        if self.status in ("failed", "partial") and CAUSE.fullmatch(self.cause) is None:
            raise ValueError(f'a cause is named like "rate.too-fast", not {self.cause!r}')

    @property
    def ok(self) -> bool:
        """Whether the criterion passed. A partial pass doesn't count."""
        return self.status == "passed"


def passed(saw: str) -> Verdict:
    """Pass the criterion. `saw` describes the observation, with the student's own numbers."""
    return Verdict("passed", saw, share=1.0)


def failed(
    cause: str,
    saw: str,
    expected: str,
    because: str,
    try_this: str,
    *,
    about_time: bool = False,
    recheck_fields: bool = False,
) -> Verdict:
    """Fail the criterion, for the reason with the id `cause`."""
    return Verdict(
        "failed",
        saw,
        expected,
        because,
        try_this,
        about_time=about_time,
        recheck_fields=recheck_fields,
        cause=cause,
    )


def partial(
    cause: str,
    share: float,
    saw: str,
    expected: str,
    because: str,
    try_this: str,
    *,
    about_time: bool = False,
) -> Verdict:
    """Pass part of the criterion. `cause`: why the rest isn't met.

    Raises ValueError if `share` isn't strictly between 0 and 1.
    """
    if not 0.0 < share < 1.0:
        raise ValueError(f"a partial verdict has a share between 0 and 1, not {share}")
    return Verdict(
        "partial", saw, expected, because, try_this, share=share, about_time=about_time, cause=cause
    )


def not_judged(why: str) -> Verdict:
    """Skip the criterion, because another one that it depends on has failed. `why`: the missing observation."""
    return Verdict("skipped", f"not judged, because {why}")


def all_of(*verdicts: Verdict) -> Verdict:
    """Pass if all verdicts pass, and list what each saw. Otherwise, return the first other verdict, as a failure."""
    for verdict in verdicts:
        if not verdict.ok:
            return replace(verdict, status="failed", share=0.0)
    return passed("; ".join(verdict.saw for verdict in verdicts))
