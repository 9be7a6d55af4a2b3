"""Judges what the driver reports: the program that calls a student's functions and publishes how each call went."""

import re
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

from workbook.criteria.criterion import Topic
from workbook.criteria.verdict import Verdict, failed
from workbook.criteria.vocabulary.known_errors import last_error
from workbook.criteria.vocabulary.values import values
from workbook.recording.recording import Recording


def driver_reports(recording: Recording, topic: Topic) -> list[str]:
    """The texts that a driver published on `topic`, in the order of their arrival."""
    return [str(text) for text in values(recording, topic)]


@dataclass
class DriverCall:
    """One call by a driver: its number, its argument as Python writes it, and how it came back (None: not reported).

    `sent`: what the answer published during the call; `later`: what it published between this call and the next.
    """

    number: int
    argument: str | None = None
    how: str | None = None
    error: str = ""
    sent: list[Any] = field(default_factory=list)
    later: list[Any] = field(default_factory=list)

    @property
    def complete(self) -> bool:
        """Whether both reports of this call arrived, so that what was published is known to belong to it."""
        return self.argument is not None and self.how is not None


_BEGINS = re.compile(r"call (?P<number>\d+): \w+\((?P<argument>.*)\)", re.DOTALL)
_ENDS = re.compile(r"call (?P<number>\d+) (?P<how>returned|raised)(?: (?P<error>.*))?", re.DOTALL)


def driver_calls(recording: Recording, report: Topic, output: Topic) -> list[DriverCall]:
    """The calls that a driver reported as "call 3: name(64)" and "call 3 returned" or "call 3 raised ...", in order.

    The first one has the number 0: it stands for the time before any call. What was published on `output` belongs to
    the call during which, or after which, it was published. A call of which a report got lost is not `complete`.
    """
    heard = [(one.published, 0, one.value.get("data")) for one in recording.topic(report.name).arrivals]
    heard += [(one.published, 1, one.value.get("data")) for one in recording.topic(output.name).arrivals]
    latest, running = DriverCall(0, "", "returned"), False
    made = [latest]
    for _, is_output, data in sorted(heard, key=lambda one: one[:2]):
        if is_output:
            (latest.sent if running else latest.later).append(data)
            continue
        text = str(data)  # others may publish there, too
        found = _BEGINS.fullmatch(text) or _ENDS.fullmatch(text)
        if found is None:
            continue
        if int(found["number"]) != latest.number:
            latest = DriverCall(int(found["number"]))
            made.append(latest)
        running = "argument" in found.groupdict()
        if running:
            latest.argument = found["argument"]
        else:
            latest.how, latest.error = found["how"], found["error"] or ""
    for one, following in pairwise(made):
        if following.argument is None or following.number != one.number + 1:
            one.later.clear()  # nobody knows whose it was
    return made


def failed_in_call(recording: Recording, reported: str, expected: str) -> Verdict | None:
    """A failed verdict that explains an error in a call by its traceback; None if the log holds none.

    `reported`: what the driver says of the call. The line of the student's file is put before it.
    """
    error = last_error(recording)
    if error is None:
        return None
    return failed(error.cause, f"{error.where}{reported}", expected, error.because, error.try_this)
