"""Judge the reports of a driver, a program that calls a student's functions and publishes each call's outcome.

The driver signs its reports (see `workbook/inside/host.py`). Criteria see only signed reports, without the signatures.
"""

import re
from collections.abc import Collection
from dataclasses import dataclass, field, replace
from hashlib import blake2b
from itertools import pairwise
from typing import Any

from workbook.criteria.criterion import Topic
from workbook.criteria.rules import Words
from workbook.criteria.verdict import Verdict
from workbook.criteria.vocabulary.known_errors import last_error
from workbook.criteria.vocabulary.values import values
from workbook.recording.recording import Arrival, Recording

WORDS = Words(__file__)

BEHIND_THE_KEY = bytes(512)
"""The driver feeds these bytes to the hash after the key, so that the key in the hash's buffer is overwritten."""
_NOT_SIGNED = "not signed by the driver: "
_FORGED = WORDS.cause("driver.not-signed", ("topic",))


def only_signed(recording: Recording, topics: Collection[str]) -> Recording:
    """Return the recording with only the driver's signed reports on these topics, each report once.

    If one of the topics has any other message, a note in the recording names that topic. A recording without a key is
    returned unchanged, because the run had no driver, or was recorded before drivers signed their reports.
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
    """Return a report's number, and the report without its signature (None if the driver didn't sign it).

    A string's signature is its prefix, and an array's signature is in the label of its first dimension.
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
    """Return a failed verdict if a message on the driver's topics isn't signed by the driver, or None otherwise."""
    note = next((note for note in recording.notes if note.startswith(_NOT_SIGNED)), None)
    return None if note is None else _FORGED.verdict(topic=note.removeprefix(_NOT_SIGNED))


def driver_reports(recording: Recording, topic: Topic) -> list[str]:
    """Return the strings that a driver published on `topic`, in the order of arrival."""
    return [str(text) for text in values(recording, topic)]


@dataclass
class DriverCall:
    """One call by a driver: its number, its argument as Python source, and its outcome `how` ("returned" or "raised").

    `argument` and `how` are None if the driver's report didn't arrive. `sent`: the messages that the answer published
    during the call. `later`: the messages that it published between this call and the next.
    """

    number: int
    argument: str | None = None
    how: str | None = None
    error: str = ""
    sent: list[Any] = field(default_factory=list)
    later: list[Any] = field(default_factory=list)

    @property
    def complete(self) -> bool:
        """Whether both reports on this call arrived. Otherwise, its messages may belong to another call."""
        return self.argument is not None and self.how is not None


_BEGINS = re.compile(r"call (?P<number>\d+): \w+\((?P<argument>.*)\)", re.DOTALL)
_ENDS = re.compile(r"call (?P<number>\d+) (?P<how>returned|raised)(?: (?P<error>.*))?", re.DOTALL)


def driver_calls(recording: Recording, report: Topic, output: Topic) -> list[DriverCall]:
    """Return the calls that a driver reported, in order.

    The reports are "call 3: name(64)" and "call 3 returned" or "call 3 raised ...". The first entry has the number 0
    and stands for the time before the first call. A message on `output` belongs to the call during or after which the
    message was published. If a report on a call was lost, the call isn't `complete`.
    """
    heard = [(one.published, 0, one.value.get("data")) for one in recording.topic(report.name).arrivals]
    heard += [(one.published, 1, one.value.get("data")) for one in recording.topic(output.name).arrivals]
    latest, running = DriverCall(0, "", "returned"), False
    made = [latest]
    for _, is_output, data in sorted(heard, key=lambda one: one[:2]):
        if is_output:
            (latest.sent if running else latest.later).append(data)
            continue
        text = str(data)  # other programs may publish on this topic, too
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
            one.later.clear()  # it's unknown which call these messages belong to
    return made


def failed_in_call(recording: Recording, reported: str, expected: str) -> Verdict | None:
    """Return a failed verdict that explains an error in a call by the log's last traceback, or None without one.

    `reported`: the driver's report on the call. The verdict quotes it after the line number in the student's file.
    """
    error = last_error(recording)
    return None if error is None else error.verdict(f"{error.where}{reported}", expected)
