"""Words about the services that a program calls."""

from workbook.criteria.mishaps import failed_by_error
from workbook.criteria.phrasing import listing
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.words_of_talk import calls_of
from workbook.criteria.words_of_topics import misspelled
from workbook.observing.recording import Recording


def calls_service(recording: Recording, service: str, service_type: str) -> Verdict:
    """At least one request of the program reached `service`; `service_type` such as "std_srvs/srv/Trigger"."""
    short = service_type.rsplit("/", 1)[1]
    expected = f"a client of type {short} that calls {service}"
    if any(call.by == "program" for call in calls_of(recording, service)):
        return passed(f"calls {service}")
    seen = {(one.name, one.type) for one in recording.clients}
    if (service, service_type) in seen:
        return _never_called(recording, service, expected)
    types = sorted(kind.rsplit("/", 1)[1] for name, kind in seen if name == service)
    if types:
        return failed(
            f"the client for {service} is of type {listing(types)}",
            expected,
            "Server and client of different types do not find each other, and nobody says so.",
            f"Import {short} from {service_type.split('/')[0]}.srv and give it to create_client().",
        )
    blamed = failed_by_error(recording, f"no client for {service}", expected)
    if blamed is not None:
        return blamed
    names = sorted(name for name, _ in seen)
    near = misspelled(recording, service, names)
    if near is not None:
        return failed(
            f"your node calls {near}, and not {service}",
            expected,
            "The two names differ; ROS matches names letter by letter, and a call that nobody serves just waits.",
            f"Write the name as {service!r}.",
        )
    return failed(
        f"no client for {service}; your program has {listing(names) or 'none'}",
        expected,
        "No create_client() call was reached, or it has a very different name.",
        f"Call self.create_client({short}, {service!r}) in __init__.",
    )


def _never_called(recording: Recording, service: str, expected: str) -> Verdict:
    blamed = failed_by_error(recording, f"the client for {service} is there, but it never calls", expected)
    return blamed or failed(
        f"the client for {service} is there, but no call arrived",
        expected,
        "No timer calls the method that asks; or the only call was made at once in __init__, before client and "
        "server had found each other, and is lost.",
        "Let a timer call the method that calls client.call_async().",
    )
