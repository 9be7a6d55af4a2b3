"""The outcome of judging one criterion, in words a student can act on."""

from dataclasses import dataclass, replace
from typing import Literal

VerdictStatus = Literal["passed", "failed", "partial"]


@dataclass(frozen=True)
class Verdict:
    """What one criterion found.

    `saw` and `expected` are facts, `because` the likely reason, `try_this` one next step. `share` is the part of the
    points that is earned (0 to 1). `about_time` marks failures that depend on rates and silences: if they come
    from robot time, the wall clock is asked before they count. `garbled` marks values that look as if a message field
    had got something of a wrong type: the program is then run once more with field checks on, to quote what they say.
    """

    status: VerdictStatus
    saw: str
    expected: str = ""
    because: str = ""
    try_this: str = ""
    share: float = 0.0
    about_time: bool = False
    garbled: bool = False

    @property
    def ok(self) -> bool:
        return self.status == "passed"


def passed(saw: str) -> Verdict:
    """The criterion holds. `saw` says what was seen, with the student's own numbers."""
    return Verdict("passed", saw, share=1.0)


def failed(
    saw: str, expected: str, because: str, try_this: str, *, about_time: bool = False, garbled: bool = False
) -> Verdict:
    """The criterion does not hold."""
    return Verdict("failed", saw, expected, because, try_this, about_time=about_time, garbled=garbled)


def partial(
    share: float, saw: str, expected: str, because: str, try_this: str, *, about_time: bool = False
) -> Verdict:
    """A part of the criterion holds. `share` lies between 0 and 1; anything else raises ValueError."""
    if not 0.0 < share < 1.0:
        raise ValueError(f"a partial verdict has a share between 0 and 1, not {share}")
    return Verdict("partial", saw, expected, because, try_this, share=share, about_time=about_time)


def all_of(*verdicts: Verdict) -> Verdict:
    """Passed if all are; otherwise the first that is not. What was seen of the passed ones is joined."""
    for verdict in verdicts:
        if not verdict.ok:
            return replace(verdict, status="failed", share=0.0)
    return passed("; ".join(verdict.saw for verdict in verdicts))
