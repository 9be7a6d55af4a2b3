"""Define verdicts, which have feedback for the student, and a cause id that stays the same if the wording changes.

Every verdict that isn't a pass names its cause first: `failed("rate.too-fast", saw, expected, because, try_this)`.

- An id has the form `word.reason`, with both parts in kebab-case. In the vocabulary, the word names the judging
  function ("rate", "program-runs"). In an exercise, it names the criterion ("results-told.late").
- An id appears exactly once in a file: as the heading of its catalog entry (see `workbook.criteria.rules`), or as a
  literal before its feedback strings. Two likely causes need two ids: if `because` differs, so does the id.
- A verdict from the vocabulary keeps its id when an exercise's criterion returns it.

In the tests, each wrong answer names the id that it must get.
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
    reason's id. `share` is the earned fraction of the points (0 to 1).

    `about_time` marks failures that depend on rates and silences. If such a failure occurs in simulated time, the
    program is judged again on the wall clock before the failure counts. The exception is a failure about the topic
    `pace_of`, if that topic provably follows simulated time. `recheck_fields` marks values that suggest a wrong type in
    a message field. The program then runs once more with field checks on, so that the feedback can quote the error that
    these checks raise.

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
    """Return a verdict that passes the criterion. `saw` describes the observation, with the student's own numbers."""
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
    """Return a verdict that fails the criterion. `cause` is the id of the reason."""
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
    """Return a verdict that earns a fraction of the criterion's points. `cause`: the id of the reason for the loss.

    Raises ValueError if `share` isn't strictly between 0 and 1.
    """
    if not 0.0 < share < 1.0:
        raise ValueError(f"a partial verdict has a share between 0 and 1, not {share}")
    return Verdict(
        "partial", saw, expected, because, try_this, share=share, about_time=about_time, cause=cause
    )


def not_judged(why: str) -> Verdict:
    """Return a verdict that skips the criterion. `why` is a clause such as "no message arrived"."""
    return Verdict("skipped", f"not judged, because {why}")


def all_of(*verdicts: Verdict) -> Verdict:
    """Return a pass with all verdicts' observations, or else the first verdict that isn't a pass, as a failure."""
    for verdict in verdicts:
        if not verdict.ok:
            return replace(verdict, status="failed", share=0.0)
    return passed("; ".join(verdict.saw for verdict in verdicts))
