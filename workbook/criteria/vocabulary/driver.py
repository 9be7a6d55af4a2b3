"""Judges what the driver reports: the program that calls a student's functions and publishes how each call went.

A driver signs its reports (see `workbook/inside/host.py`), and criteria see those alone, without the signatures.
"""

import re
from collections.abc import Collection
from dataclasses import dataclass, field, replace
from hashlib import blake2b
from itertools import pairwise
from typing import Any

from workbook.criteria.criterion import Topic
from workbook.criteria.verdict import Verdict, failed
from workbook.criteria.vocabulary.known_errors import last_error
from workbook.criteria.vocabulary.values import values
from workbook.recording.recording import Arrival, Recording

BEHIND_THE_KEY = bytes(512)
"""What the driver feeds to the hash after the key, to have the key overwritten."""
_NOT_SIGNED = "not signed by the driver: "


def only_signed(recording: Recording, topics: Collection[str]) -> Recording:
    """The recording as criteria see it: on these topics, only what the driver has signed, each report once.

    If there was something else, a note says on which topic. Without a key, there was no driver, or one of an old
    recording; then everything stays as it is.
    """
    if not recording.process.driver_key:
        return recording
    keyed = blake2b(key=bytes.fromhex(recording.process.driver_key), digest_size=16)
    keyed.update(BEHIND_THE_KEY)
    seen, forged, numbers = dict(recording.topics), list[str](), set[str]()
    for name in sorted({*topics} & {*seen}):
        reports = []
        for one in seen[name].arrivals:
            number, report = _opened(keyed.copy(), name, one)
            if report is not None and number not in numbers:
                numbers.add(number)
                reports.append(report)
            else:
                forged.append(f"{_NOT_SIGNED}{name}")
        seen[name] = replace(seen[name], arrivals=tuple(reports))
    return replace(recording, topics=seen, notes=(*recording.notes, *dict.fromkeys(forged)))


def _opened(keyed: Any, topic: str, arrival: Arrival) -> tuple[str, Arrival | None]:
    """The number of a report, and the report without its signature; None for one that the driver has not signed.

    A text is signed in front of it, and an array in the label of its first dimension.
    """
    value = arrival.value
    try:
        is_text = isinstance(value["data"], str)
        signed = value["data"] if is_text else value["layout"]["dim"][0]["label"]
        number, signature, text = signed.split(" ", 2)
        keyed.update(f"{topic}\n{number}\n{text}".encode())
        if keyed.hexdigest() == signature and (is_text or text == " ".join(map(str, value["data"]))):
            return number, replace(arrival, value={**value, "data": text if is_text else value["data"]})
    except (LookupError, TypeError, ValueError, AttributeError):
        pass
    return "", None


def forged_report(recording: Recording) -> Verdict | None:
    """A failed verdict if something other than the driver has published on a topic of the driver; None if not."""
    note = next((note for note in recording.notes if note.startswith(_NOT_SIGNED)), None)
    if note is None:
        return None
    topic = note.removeprefix(_NOT_SIGNED)
    return failed(
        "driver.not-signed",
        f"a message on {topic} without the signature of the judge's driver",
        f"on {topic}, only messages that the driver has signed",
        "The driver calls your code and reports the results on this topic. But your program publishes on this "
        "topic, too.",
        f"Do not publish on {topic}.",
    )


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
