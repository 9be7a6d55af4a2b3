"""The vocabulary for drivers, on recordings made by hand."""

import os
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from std_msgs.msg import Float32, Int32MultiArray, String

import workbook.criteria as see
from tests.criteria.by_hand import ended_by_itself, on_topic, recorded
from workbook.criteria import topic
from workbook.criteria.vocabulary.driver import only_signed
from workbook.inside import host
from workbook.recording.recording import Arrival, ProcessRecord, Recording

REPORT = topic("/driver/report", String)
LOG = (
    'Traceback (most recent call last):\n  File "/answers/answer.py", line 7, in on_tick\n    self.send()\n'
    "NameError: name 'Float32' is not defined\n"
)


def test_reports_come_in_the_order_of_their_arrival() -> None:
    said = on_topic(REPORT.name, "std_msgs/msg/String", [1.0, 2.0], ["made", "call 1 returned"])
    assert see.driver_reports(recorded(said), REPORT) == ["made", "call 1 returned"]


def test_a_driver_that_said_nothing_has_no_reports() -> None:
    assert see.driver_reports(recorded(), REPORT) == []


def test_a_call_that_raised_is_explained_by_its_traceback() -> None:
    verdict = see.failed_in_call(recorded(process=ended_by_itself(LOG)), "send() raised", "no error")
    assert verdict is not None
    assert (verdict.status, verdict.saw, verdict.expected) == ("failed", "line 7: send() raised", "no error")
    assert verdict.cause.startswith("error.") and verdict.because and verdict.try_this


def test_without_a_traceback_nothing_is_explained() -> None:
    assert see.failed_in_call(recorded(process=ended_by_itself("all is well\n")), "it raised", "") is None


BATTERY = topic("/robot/battery", Float32)


def calls_of(*reports: tuple[float, str], sent: dict[float, float]) -> list[see.DriverCall]:
    """Return the calls that the criteria reconstruct from these reports and numbers, each at its time (s)."""
    said = on_topic(
        REPORT.name, "std_msgs/msg/String", [at for at, _ in reports], [text for _, text in reports]
    )
    went_out = on_topic(BATTERY.name, times=sent.keys(), values=list(sent.values()))
    return see.driver_calls(recorded(said, went_out), REPORT, BATTERY)


def test_what_went_out_belongs_to_the_call_in_or_after_which_it_did() -> None:
    before, first, second = calls_of(
        (1.0, "call 1: publish_level(64)"),
        (1.2, "call 1 returned"),
        (2.0, "call 2: publish_level(None)"),
        (2.2, "call 2 raised TypeError: None"),
        sent={0.5: 1.0, 1.1: 64.0, 1.5: 65.0},
    )
    assert (before.number, before.later) == (0, [1.0])
    assert (first.argument, first.how, first.sent, first.later) == ("64", "returned", [64.0], [65.0])
    assert (second.argument, second.how, second.error, second.sent) == (
        "None",
        "raised",
        "TypeError: None",
        [],
    )
    assert first.complete and second.complete


def test_a_call_of_which_a_report_got_lost_is_not_complete() -> None:
    _, first, second, third = calls_of(
        (1.0, "call 1: publish_level(64)"),
        (1.2, "call 1 returned"),
        (2.2, "call 2 returned"),
        (3.0, "call 3: publish_level(7)"),
        sent={1.1: 64.0, 2.1: 65.0, 3.1: 7.0},
    )
    assert (
        first.complete and first.later == []
    )  # 65.0 was published during the second call, which was not announced
    assert not second.complete
    assert (third.how, third.sent, third.complete) == (None, [7.0], False)


# --- signatures -------------------------------------------------------------------------------------------------

TEXT, ARRAY = "std_msgs/msg/String", "std_msgs/msg/Int32MultiArray"
KEY = bytes(range(32))
Sign = Callable[[str, str], str]


@pytest.fixture
def sign() -> Sign:
    """Return a function that signs as a driver with this key does."""
    kept, (read_fd, write_fd) = os.dup(0), os.pipe()
    os.write(write_fd, KEY)
    os.dup2(read_fd, 0)
    try:
        return host.signer()
    finally:
        os.dup2(kept, 0)
        for one in (kept, read_fd, write_fd):
            os.close(one)


def seen_by_criteria(*values: Any, key: bytes = KEY) -> Recording:
    """Return these reports as the criteria get them."""
    reports = on_topic(REPORT.name, TEXT, [float(at) for at in range(len(values))], list(values))
    process = ProcessRecord(program="answer.py", driver_key=key.hex())
    return only_signed(recorded(reports, process=process), (REPORT.name,))


def test_what_the_driver_has_signed_is_seen_without_its_signature(sign: Sign) -> None:
    texts = ["made", "call 1: publish_level('a b')", "call 1 raised ValueError: \N{SNOWMAN} \t", ""]
    found = seen_by_criteria(*(sign(REPORT.name, text) for text in texts))
    assert see.driver_reports(found, REPORT) == texts
    assert found.notes == () and see.program_runs(found).ok


def test_a_report_that_no_message_can_carry_is_changed_before_it_is_signed(sign: Sign) -> None:
    long = seen_by_criteria(sign(REPORT.name, "x" * 5000), sign(REPORT.name, "a\0b\ud800"))
    assert see.driver_reports(long, REPORT) == ["x" * host.LONGEST_REPORT, "a b\\ud800"]


@pytest.mark.parametrize(
    "forged",
    [
        "done",
        "",
        "7 0123456789abcdef0123456789abcdef done",
        "1 {signature} done",
        "2 {signature} made",
        "1 {signature} made",
        5,
        None,
        ["made"],
        {"length": 5000, "first": "1 2 3"},
    ],
    ids=[
        "unsigned",
        "empty",
        "invented",
        "other text",
        "other number",
        "twice",
        "int",
        "null",
        "list",
        "cut",
    ],
)
def test_a_report_that_the_driver_has_not_signed_is_told_and_not_seen(sign: Sign, forged: Any) -> None:
    made = sign(REPORT.name, "made")
    if isinstance(forged, str):
        forged = forged.format(signature=made.split()[1])
    found = seen_by_criteria(made, forged)
    assert see.driver_reports(found, REPORT) == ["made"]
    verdict = see.program_runs(found)
    assert not verdict.ok and verdict.cause == "driver.not-signed" and REPORT.name in verdict.saw


def test_a_signature_counts_on_its_own_topic_alone(sign: Sign) -> None:
    found = seen_by_criteria(sign("/driver/changed", "made"))
    assert see.program_runs(found).cause == "driver.not-signed"


@pytest.mark.parametrize(
    ("data", "is_seen"), [([1, 20], True), ([1, 19], False), ([1], False), ([], False), ("1 20", False)]
)
def test_an_array_is_signed_in_its_label(sign: Sign, data: Any, is_seen: bool) -> None:
    heard = topic("/robot/heard", Int32MultiArray, signed=True)
    label = {"label": sign(heard.name, "1 20"), "size": 0, "stride": 0}
    value = {"layout": {"dim": [label], "data_offset": 0}, "data": data}
    reports = replace(on_topic(heard.name, ARRAY), arrivals=(Arrival(1.0, 1.0, value),))
    found = only_signed(recorded(reports, process=ProcessRecord(driver_key=KEY.hex())), (heard.name,))
    assert see.values(found, heard) == ([data] if is_seen else [])
    assert see.program_runs(found).ok is is_seen


def test_without_a_key_everything_is_seen_as_it_is() -> None:
    """Recordings by earlier versions contain no key, but can be judged again."""
    found = seen_by_criteria("made", "done", key=b"")
    assert see.driver_reports(found, REPORT) == ["made", "done"]
    assert found.notes == ()
