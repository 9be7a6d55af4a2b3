"""Words about what was said to a program, and how it answered."""

import statistics
from collections.abc import Sequence
from typing import Any

from workbook.criteria.criterion import Topic
from workbook.criteria.mishaps import failed_by_error
from workbook.criteria.phrasing import count, listing
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.words_of_topics import misspelled
from workbook.observing.recording import Arrival, CallSeen, Recording, Said


def said(recording: Recording, topic: str) -> list[Said]:
    """What the bench published on `topic`, in order."""
    return [one for one in recording.said if one.topic == topic]


def calls_of(recording: Recording, service: str) -> list[CallSeen]:
    """The calls of a service, in order."""
    return [call for call in recording.calls if call.service == service]


def listens(recording: Recording, topic: Topic) -> Verdict:
    """The program subscribes to `topic` with the right type."""
    seen = recording.topic(topic.name)
    expected = f"a subscription to {topic.name} of type {topic.short_type}"
    types = sorted({subscriber.type for subscriber in seen.subscribers})
    if topic.type in types:
        return passed(f"listens to {topic.name}")
    if types:
        got = listing([name.rsplit("/", 1)[1] for name in types])
        return failed(
            f"a subscription to {topic.name} for {got}",
            expected,
            "The subscription was created with another message type.",
            f"Import {topic.short_type} from {topic.type.split('/')[0]}.msg and give it to create_subscription().",
        )
    blamed = failed_by_error(recording, f"nobody listens to {topic.name}", expected)
    if blamed is not None:
        return blamed
    near = misspelled(
        recording, topic.name, [name for name, other in recording.topics.items() if other.subscribers]
    )
    if near is not None:
        return failed(
            f"your node listens to {near}, and not to {topic.name}",
            expected,
            "The two names differ; ROS matches names letter by letter.",
            f"Write the name as {topic.name!r}.",
        )
    return failed(
        f"nobody listens to {topic.name}",
        expected,
        "No create_subscription() call was reached.",
        f"Call create_subscription({topic.short_type}, {topic.name!r}, self.on_message, 10) in __init__.",
    )


def latencies(
    words: Sequence[Said], arrivals: Sequence[Arrival], *, field: str = "data"
) -> list[float | None]:
    """For each message said: seconds until a message with the same value was published; None if none was.

    Both are told apart by the value of `field`, so let a script say every value once.
    """
    found: list[float | None] = []
    for word in words:
        wanted = word.value[field]
        times = [
            one.published
            for one in arrivals
            if _same(one.value.get(field), wanted) and one.published >= word.wall
        ]
        found.append(min(times) - word.wall if times else None)
    return found


def _same(one: Any, other: Any) -> bool:
    if isinstance(one, float) and isinstance(other, (int, float)):
        return abs(one - other) <= 1e-6 * max(1.0, abs(other))
    return bool(one == other)


def offers(recording: Recording, service: str, service_type: str) -> Verdict:
    """The program offers `service` with the right type, such as "std_srvs/srv/Trigger"."""
    short = service_type.rsplit("/", 1)[1]
    expected = f"a service {service} of type {short}"
    seen = {one.name: one.type for one in recording.services}
    if seen.get(service) == service_type:
        return passed(f"offers {service}")
    if service in seen:
        return failed(
            f"{service} is of type {seen[service].rsplit('/', 1)[1]}",
            expected,
            "create_service() got another type.",
            f"Import {short} from {service_type.split('/')[0]}.srv.",
        )
    blamed = failed_by_error(recording, f"no service {service}", expected)
    if blamed is not None:
        return blamed
    return failed(
        f"no service {service}; your program offers {listing(sorted(seen)) or 'none'}",
        expected,
        "No create_service() call was reached, or it has another name.",
        f"Call create_service({short}, {service!r}, self.on_request) in __init__.",
    )


def processor_share(
    recording: Recording, begin: float | None = None, end: float | None = None
) -> float | None:
    """Share of one processor (1.0: all of it) that the program used between two moments of wall time (s).

    None when the recording holds fewer than two samples from then.
    """
    samples = [
        (wall, used)
        for wall, used in recording.process.processor
        if (begin is None or wall >= begin) and (end is None or wall <= end)
    ]
    if len(samples) < 2 or samples[-1][0] <= samples[0][0]:
        return None
    return (samples[-1][1] - samples[0][1]) / (samples[-1][0] - samples[0][0])


def answered_calls(recording: Recording, service: str) -> str:
    """How many calls of a service were made and answered, in words."""
    calls = calls_of(recording, service)
    answered = [call.answered_wall - call.wall for call in calls if call.answered_wall is not None]
    took = f", in {statistics.median(answered):.2f} s" if answered else ""
    return f"{count(len(calls), 'call')} of {service}, {len(answered)} answered{took}"
