"""The outcome of judging one criterion, in words a student can act on, under a cause id that does not change with them.

Whatever is not passed names its cause first: `failed("rate.too-fast", saw, expected, because, try_this)`.

- An id is `word.reason`, both in kebab-case. In the vocabulary the word is the function that judges ("rate",
  "program-runs"), in an exercise it is the criterion ("results-told.late").
- An id stands at exactly one place of a file, as a literal, before the words that belong to it. Two likely causes are
  two ids: where `because` differs, so does the id. A shared `expected` goes into a variable, a shared pair of
  arguments into a local function that takes the id first.
- A verdict that the vocabulary made keeps its own id when an exercise passes it on.

Wrong answers name the id that they must get.
"""

import re
from dataclasses import dataclass, replace
from typing import Literal

VerdictStatus = Literal["passed", "failed", "partial", "skipped"]

CAUSE = re.compile(r"[a-z][a-z0-9]*(?:-[a-z0-9]+)*\.[a-z][a-z0-9]*(?:-[a-z0-9]+)*")
"""What a cause id looks like: "rate.too-fast"."""


@dataclass(frozen=True)
class Verdict:
    """What one criterion found, and why.

    `saw` and `expected` are facts, `because` the likely reason, `try_this` one next step; `cause` is the id of this
    reason. `share` is the part of the points that is earned (0 to 1). `about_time` marks failures that depend on rates
    and silences: if they come from simulated time, the program is judged on the wall clock before they count,
    unless `pace_of` names the topic whose pace was judged, and that topic is proved to follow simulated time.
    `recheck_fields` marks values that suggest a wrong type in a message field: the program is then run once more with
    field checks on, to quote their error.

    Raises ValueError when the cause of a verdict that takes points away is no id.
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
        """Whether the criterion passed; a partial pass does not count."""
        return self.status == "passed"


def passed(saw: str) -> Verdict:
    """The criterion is met. `saw` says what was seen, with the student's own numbers."""
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
    """The criterion is not met, for the reason that the id `cause` stands for."""
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
    """A part of the criterion is met. `cause`: why the rest is not met.

    Raises ValueError when `share` does not lie between 0 and 1.
    """
    if not 0.0 < share < 1.0:
        raise ValueError(f"a partial verdict has a share between 0 and 1, not {share}")
    return Verdict(
        "partial", saw, expected, because, try_this, share=share, about_time=about_time, cause=cause
    )


def not_judged(why: str) -> Verdict:
    """Another criterion has failed, and without it nothing can be said of this one. `why`: what is missing."""
    return Verdict("skipped", f"not judged, because {why}")


def all_of(*verdicts: Verdict) -> Verdict:
    """Passed if all of them are, and says what each one saw. Otherwise it is the first one that is not passed."""
    for verdict in verdicts:
        if not verdict.ok:
            return replace(verdict, status="failed", share=0.0)
    return passed("; ".join(verdict.saw for verdict in verdicts))
