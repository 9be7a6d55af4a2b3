"""Which service a program calls: the right one, another one, one of another type, or none."""

from dataclasses import replace

import pytest

import workbook.criteria as see
from tests.criteria.by_hand import LIVING, recorded
from workbook.recording.recording import CallSeen, Recording, ServiceSeen

SERVICE, TRIGGER, SET_BOOL = "/robot/self_test", "std_srvs/srv/Trigger", "std_srvs/srv/SetBool"
TRACEBACK = (
    'Traceback (most recent call last):\n  File "/answers/answer.py", line 7, in <module>\n    main()\n'
    "NameError: name 'Trigger' is not defined\n"
)


def with_clients(*clients: tuple[str, str], log: str = "") -> Recording:
    seen = tuple(ServiceSeen(name, kind) for name, kind in clients)
    return replace(recorded(), clients=seen, process=replace(LIVING, log=log))


def test_one_call_that_arrived_suffices() -> None:
    call = CallSeen(SERVICE, "program", 1.0, 1.2, {})
    assert see.calls_service(replace(recorded(), calls=(call,)), SERVICE, TRIGGER).ok
    by_bench = replace(recorded(), calls=(replace(call, by="judge"),))
    assert not see.calls_service(by_bench, SERVICE, TRIGGER).ok


@pytest.mark.parametrize(
    ("recording", "words"),
    [
        (with_clients(("/robot/selftest", TRIGGER)), "your node calls /robot/selftest, not"),
        (with_clients(("/camera/reset", TRIGGER)), "your program has /camera/reset"),
        (with_clients((SERVICE, SET_BOOL)), "is of type SetBool"),
        (with_clients((SERVICE, TRIGGER)), "no request arrived"),
        (
            with_clients((SERVICE, TRIGGER), log=TRACEBACK),
            "never sends a request; error in line 7: NameError",
        ),
        (with_clients(log=TRACEBACK), "no client for /robot/self_test; error in line 7: NameError"),
        (with_clients(), "your program has none"),
    ],
)
def test_a_call_that_never_came_is_told_with_its_reason(recording: Recording, words: str) -> None:
    verdict = see.calls_service(recording, SERVICE, TRIGGER)
    assert not verdict.ok
    assert words in verdict.saw
    assert verdict.expected and verdict.because and verdict.try_this
