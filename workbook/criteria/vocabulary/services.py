"""Judges services: those that a program offers, those that it calls, and the outcome of the calls."""

import statistics

from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.vocabulary.known_errors import failed_by_error
from workbook.criteria.vocabulary.phrasing import count, listing
from workbook.criteria.vocabulary.spins import held_by_a_spin
from workbook.criteria.vocabulary.topics import misspelled
from workbook.recording.recording import CallSeen, Recording


def calls_of(recording: Recording, service: str) -> list[CallSeen]:
    """The calls of a service, in order: those of the program and those of the script."""
    return [call for call in recording.calls if call.service == service]


def answered_calls(recording: Recording, service: str) -> str:
    """How many calls of a service were made and answered, and how fast, in words."""
    calls = calls_of(recording, service)
    answered = [call.answered_wall - call.wall for call in calls if call.answered_wall is not None]
    took = f", in {statistics.median(answered):.2f} s" if answered else ""
    return f"{count(len(calls), 'call')} of {service}, {len(answered)} answered{took}"


def offers(recording: Recording, service: str, service_type: str) -> Verdict:
    """The program offers `service` with the right type, such as "std_srvs/srv/Trigger"."""
    short = service_type.rsplit("/", 1)[1]
    expected = f"a service {service} of type {short}"
    seen = {one.name: one.type for one in recording.services}
    if seen.get(service) == service_type:
        return passed(f"offers {service}")
    if service in seen:
        return failed(
            "offers.other-type",
            f"{service} is of type {seen[service].rsplit('/', 1)[1]}",
            expected,
            "create_service() received a different type.",
            f"Import {short} from {service_type.split('/')[0]}.srv.",
        )
    nothing = f"no service {service}"
    blamed = failed_by_error(recording, nothing, expected) or held_by_a_spin(recording, nothing, expected)
    return blamed or failed(
        "offers.nothing",
        f"no service {service}; your program offers {listing(sorted(seen)) or 'none'}",
        expected,
        "No create_service() call was reached, or it uses another name.",
        f"Call create_service({short}, {service!r}, self.on_request) in __init__.",
    )


def calls_service(recording: Recording, service: str, service_type: str) -> Verdict:
    """At least one request of the program reached `service`; `service_type` such as "std_srvs/srv/Trigger"."""
    if any(call.by == "program" for call in calls_of(recording, service)):
        return passed(f"calls {service}")
    short = service_type.rsplit("/", 1)[1]
    expected = f"a client of type {short} that calls {service}"
    seen = {(one.name, one.type) for one in recording.clients}
    if (service, service_type) in seen:
        return _never_called(recording, service, expected)
    types = sorted(kind.rsplit("/", 1)[1] for name, kind in seen if name == service)
    if types:
        return failed(
            "calls-service.other-type",
            f"the client for {service} is of type {listing(types)}",
            expected,
            "A server and a client of different types never connect, and no error reports it.",
            f"Import {short} from {service_type.split('/')[0]}.srv and give it to create_client().",
        )
    blamed = failed_by_error(recording, f"no client for {service}", expected)
    return blamed or _no_client(recording, service, short, expected)


def _no_client(recording: Recording, service: str, short: str, expected: str) -> Verdict:
    names = sorted(name for name, _ in {(one.name, one.type) for one in recording.clients})
    near = misspelled(recording, service, names)
    if near is not None:
        return failed(
            "calls-service.other-name",
            f"your node calls {near}, not {service}",
            expected,
            "The two names differ. ROS compares names letter by letter, so the call just waits for a server.",
            f"Write the name as {service!r}.",
        )
    return held_by_a_spin(recording, f"no client for {service}", expected) or failed(
        "calls-service.no-client",
        f"no client for {service}; your program has {listing(names) or 'none'}",
        expected,
        "No create_client() call was reached, or it uses a very different name.",
        f"Call self.create_client({short}, {service!r}) in __init__.",
    )


def _never_called(recording: Recording, service: str, expected: str) -> Verdict:
    blamed = failed_by_error(
        recording, f"the client for {service} exists, but never sends a request", expected
    )
    return blamed or failed(
        "calls-service.never-called",
        f"the client for {service} exists, but no call arrived",
        expected,
        "No timer calls the method that sends requests. Or the only call was made in __init__, before client and "
        "server had found each other, and was lost.",
        "Let a timer call a method that calls client.call_async().",
    )
