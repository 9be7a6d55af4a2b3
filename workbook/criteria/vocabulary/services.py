"""Judge the services that a program offers and the services that it calls."""

import statistics
from typing import Any

from workbook.criteria.rules import Words
from workbook.criteria.verdict import Verdict, passed
from workbook.criteria.vocabulary.known_errors import failed_by_error
from workbook.criteria.vocabulary.phrasing import count
from workbook.criteria.vocabulary.spins import held_by_a_spin
from workbook.criteria.vocabulary.topics import misspelled
from workbook.recording.recording import CallSeen, Recording

WORDS = Words(__file__)


_OFFERED = ("service", "short", "package", "offered")
_OFFERS_BY_ERROR = WORDS.seen("offers.by-error", _OFFERED)
_OFFERS_OTHER_TYPE = WORDS.cause("offers.other-type", _OFFERED)
_OFFERS_NOTHING = WORDS.cause("offers.nothing", _OFFERED)
_CALLED = ("service", "short", "package", "called")
_CALLS_BY_ERROR = WORDS.seen("calls-service.by-error", _CALLED)
_SILENT = WORDS.seen("calls-service.silent", _CALLED)
_NEVER_CALLED = WORDS.cause("calls-service.never-called", _CALLED)
_CALLS_OTHER_TYPE = WORDS.cause("calls-service.other-type", _CALLED)
_CALLS_OTHER_NAME = WORDS.cause("calls-service.other-name", _CALLED)
_NO_CLIENT = WORDS.cause("calls-service.no-client", _CALLED)


def answered_calls(recording: Recording, service: str) -> str:
    """Summarize the calls to a service: their number, the number of responses, and the median response time (s)."""
    calls = calls_of(recording, service)
    answered = [call.answered_wall - call.wall for call in calls if call.answered_wall is not None]
    took = f", in {statistics.median(answered):.2f} s" if answered else ""
    return f"{count(len(calls), 'call')} of {service}, {len(answered)} answered{took}"


def calls_of(recording: Recording, service: str) -> list[CallSeen]:
    """Return all calls to a service in order, both by the program and by the script."""
    return [call for call in recording.calls if call.service == service]


def offers(recording: Recording, service: str, service_type: str) -> Verdict:
    """Check that the program offers `service` with the right type, such as "std_srvs/srv/Trigger"."""
    seen = {one.name: one.type for one in recording.services}
    if seen.get(service) == service_type:
        return passed(f"offers {service}")
    given = _given(service, service_type)
    if service in seen:
        return _OFFERS_OTHER_TYPE.verdict(**given, offered=seen[service].rsplit("/", 1)[1])
    told = _OFFERS_BY_ERROR(**given)
    early = failed_by_error(recording, *told) or held_by_a_spin(recording, *told)
    return early or _OFFERS_NOTHING.verdict(**given, offered=sorted(seen) or "none")


def calls_service(recording: Recording, service: str, service_type: str) -> Verdict:
    """Check that at least one of the program's requests reached `service`.

    `service_type`: the required type, such as "std_srvs/srv/Trigger".
    """
    if any(call.by == "program" for call in calls_of(recording, service)):
        return passed(f"calls {service}")
    given = _given(service, service_type)
    seen = {(one.name, one.type) for one in recording.clients}
    if (service, service_type) in seen:
        return failed_by_error(recording, *_SILENT(**given)) or _NEVER_CALLED.verdict(**given)
    types = sorted(kind.rsplit("/", 1)[1] for name, kind in seen if name == service)
    if types:
        return _CALLS_OTHER_TYPE.verdict(**given, called=types)
    told = _CALLS_BY_ERROR(**given)
    blamed = failed_by_error(recording, *told)
    if blamed is not None:
        return blamed
    names = sorted(name for name, _ in seen)
    near = misspelled(recording, service, names)
    if near is not None:
        return _CALLS_OTHER_NAME.verdict(**given, called=near)
    return held_by_a_spin(recording, *told) or _NO_CLIENT.verdict(**given, called=names or "none")


def _given(service: str, service_type: str) -> dict[str, Any]:
    return {
        "service": service,
        "short": service_type.rsplit("/", 1)[1],
        "package": service_type.split("/")[0],
    }
