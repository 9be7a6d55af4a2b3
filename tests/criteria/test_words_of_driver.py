"""Words about the driver, on recordings made by hand."""

from std_msgs.msg import Float32, String

import workbook.criteria as see
from tests.criteria.by_hand import ended_by_itself, on_topic, recorded
from workbook.criteria import topic

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
    """What is made of these reports and numbers, each at its moment (s)."""
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
    )  # 65.0 went out during the second call, which was not announced
    assert not second.complete
    assert (third.how, third.sent, third.complete) == (None, [7.0], False)
