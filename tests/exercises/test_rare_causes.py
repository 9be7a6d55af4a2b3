"""Causes that no wrong answer reaches, on recordings made by hand."""

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest

from tests.criteria.by_hand import LIVING, on_topic, publisher, recorded
from workbook.criteria import Verdict
from workbook.exercise.conclusiveness import BUSY_MACHINE
from workbook.exercise.definition import load_exercise
from workbook.recording.recording import CallSeen, Recording, Said, TopicRecording

ROOT = Path(__file__).resolve().parents[2]
FLOAT, TEXT, NUMBERS = "std_msgs/msg/Float32", "std_msgs/msg/String", "std_msgs/msg/Int32MultiArray"


def judged(stem: str, criterion: str, recording: Recording) -> Verdict:
    """One criterion of an exercise, whatever it needs."""
    return next(one for one in load_exercise(stem, ROOT).criteria if one.id == criterion)(recording)


def refused_for(cause: str, verdict: Verdict, *words: str) -> None:
    assert (verdict.status, verdict.cause) == ("failed", cause), verdict
    assert verdict.expected and verdict.because and verdict.try_this
    for word in words:
        assert word in verdict.saw


def text(name: str, *said: str) -> TopicRecording:
    """A topic with one text every 0.1 s."""
    return on_topic(name, TEXT, [0.1 * (n + 1) for n in range(len(said))], said)


def test_01_a_thread_that_spins_raises() -> None:
    log = 'Exception in thread Thread-1:\nTraceback (most recent call last):\n  File "/rclpy/executors.py", line 701\n'
    process = replace(LIVING, end_log=f"arms parked\n{log}")
    verdict = judged("01_the_context", "ends_cleanly", recorded(process=process))
    refused_for("ends-cleanly.thread-raised", verdict, "of a thread")


def test_01_an_error_of_its_own_in_a_thread_is_not_blamed_on_spin() -> None:
    log = (
        'Exception in thread Thread-1:\nTraceback (most recent call last):\n  File "/answers/answer.py", line 7, in f\n'
        "ValueError: no arm has the number 3\n"
    )
    process = replace(LIVING, end_log=f"arms parked\n{log}")
    verdict = judged("01_the_context", "ends_cleanly", recorded(process=process))
    assert verdict.status == "failed" and verdict.cause.startswith("error."), verdict
    assert "line 7" in verdict.saw and "ValueError: no arm has the number 3" in verdict.saw


@pytest.mark.parametrize(
    ("said_after", "cause"),
    [((0.75, 0.79), ""), ((0.72, 0.76), "unanswered-told.always-early"), ((0.72,), "")],
    ids=["one-in-time", "all-early", "one-call-only"],
)
def test_12_one_report_may_be_early_and_not_all_of_them(said_after: Sequence[float], cause: str) -> None:
    moments = [3.0 + 2.0 * n for n in range(len(said_after))]
    asked = [CallSeen("/robot/self_test", "program", at, at, {}) for at in moments]
    told = on_topic(
        "/robot/health",
        TEXT,
        [call.t + wait for call, wait in zip(asked, said_after, strict=True)],
        ["no answer"] * len(asked),
    )
    verdict = judged("12_services", "unanswered_told", replace(recorded(told), calls=tuple(asked)))
    assert (verdict.cause, verdict.ok) == (cause, not cause), verdict


def test_02_faults_in_another_namespace() -> None:
    faults = TopicRecording("/camera/faults", (publisher(TEXT, "/robot/camera"),))
    verdict = judged("02_nodes", "shared_faults", recorded(faults))
    refused_for("shared-faults.other-name", verdict, "something reports on /camera/faults")


def test_03_a_float_raises() -> None:
    report = text("/driver/report", "call 1: publish_level(87.25)", "call 1 raised KeyError: 'level'")
    verdict = judged("03_publishers_and_messages", "floats_arrive", recorded(report))
    refused_for("number.raised", verdict, "publish_level(87.25) raised KeyError: 'level'")


Call = tuple[str, str, list[float], list[float]]
WELL: list[Call] = [("87.25", "returned", [87.25], []), ("99.9", "returned", [99.9], [])]


def calls(*made: Call, uncalled: Sequence[float] = ()) -> Recording:
    """Calls of publish_level: argument, how it came back, what went out meanwhile, and what after it."""
    said: list[tuple[float, str]] = []
    sent = [(0.1, number) for number in uncalled]
    for number, (argument, how, meanwhile, later) in enumerate(made, start=1):
        said += [
            (number, f"call {number}: publish_level({argument})"),
            (number + 0.5, f"call {number} {how}"),
        ]
        sent += [(number + 0.1, one) for one in meanwhile] + [(number + 0.6, one) for one in later]
    report = on_topic("/driver/report", TEXT, [at for at, _ in said], [words for _, words in said])
    return recorded(
        report, on_topic("/robot/battery", FLOAT, [at for at, _ in sent], [one for _, one in sent])
    )


@pytest.mark.parametrize(
    ("cause", "criterion", "made"),
    [
        ("number.mistake", "sends", [("87.25", "raised NameError: name 'valeu' is not defined", [], [])]),
        ("number.refused-later", "floats_arrive", [*WELL, ("87.25", "raised ValueError: broken", [], [])]),
        ("number.int-refused", "numbers_arrive", [("0.0", "returned", [0.0], []), ("0", "raised TypeError", [], [])]),
        ("number.zero-dropped", "zero_arrives", [*WELL, ("0.0", "returned", [], [])]),
        ("number.stops", "floats_arrive", [*WELL, ("0.1", "returned", [], []), ("1.0", "returned", [], [])]),
        ("number.one-behind", "floats_arrive", [*WELL, ("0.1", "returned", [99.9], [])]),
        ("number.one-behind", "floats_arrive", [("87.25", "returned", [], []), ("99.9", "returned", [87.25], [])]),
        ("number.changed", "floats_arrive", [*WELL, ("0.1", "returned", [20.0], [])]),
        ("number.sent-again", "floats_arrive", [*WELL, ("0.1", "returned", [0.1], [0.1])]),
        ("number.sent-later", "floats_arrive", [*WELL, ("0.1", "returned", [], [0.1])]),
        ("refusal.sent-later", "no_number_refused", [*WELL, ("None", "raised TypeError: None", [], [5.0])]),
        ("refusal.numpy-not-finite", "not_finite_refused", [
            *[(one, "raised ValueError", [], []) for one in ("nan", "inf", "-inf")],
            ("np.float32(nan)", "returned", [math.nan], []),
        ]),
        ("refusal.look-alike-not-converted", "look_alikes_refused", [*WELL, ("'50'", "returned", [0.0], [])]),
        ("refusal.bool-sent", "look_alikes_refused", [*WELL, ("False", "returned", [0.0], [])]),
    ],
)  # fmt: skip
def test_03_what_a_call_did(cause: str, criterion: str, made: Sequence[Call]) -> None:
    refused_for(cause, judged("03_publishers_and_messages", criterion, calls(*made)), "publish_level(")


def test_03_something_goes_out_before_any_call() -> None:
    verdict = judged("03_publishers_and_messages", "floats_arrive", calls(*WELL, uncalled=[50.0]))
    refused_for("floats-arrive.uncalled", verdict, "50.0 went out before")


def test_03_a_call_of_which_a_report_got_lost_is_not_judged() -> None:
    recording = calls(*WELL, ("0.1", "returned", [0.1], []))
    said = recording.topic("/driver/report")
    lost = replace(said, arrivals=tuple(one for one in said.arrivals if "(99.9)" not in one.value["data"]))
    recording = replace(recording, topics={**recording.topics, lost.name: lost})
    assert judged("03_publishers_and_messages", "floats_arrive", recording).ok


def monitor(*readings: float) -> Recording:
    """A monitor that made its publisher when readings were coming in, and passed these on."""
    seen = on_topic("/monitor/battery", FLOAT, [0.1 * n for n in range(len(readings))], readings)
    late = replace(seen, publishers=tuple(replace(one, first_seen=2.0) for one in seen.publishers))
    return replace(recorded(late), said=(Said("/robot/battery", 0.5, 1.0, {"data": 52.0}),))


def test_04_a_late_publisher_loses_everything() -> None:
    refused_for(
        "in-order.publisher-made-late", judged("04_subscriptions_and_callbacks", "passes_on", monitor())
    )


def test_04_a_late_publisher_loses_the_first_reading() -> None:
    verdict = judged("04_subscriptions_and_callbacks", "in_order", monitor(50.25, 49.5, 49.25))
    refused_for("in-order.first-ones-lost", verdict, "3 of 41", "52 %")


def pumped(announced: Sequence[str], log: str = "", **told: Sequence[list[int]]) -> Recording:
    """What the driver of 06 announced, and what the robot told on its topics."""
    topics: list[TopicRecording] = [text("/driver/pump", *announced)]
    for name, pairs in told.items():
        times = [0.1 * n for n in range(len(pairs))]
        topics.append(on_topic(f"/robot/{name}", NUMBERS, times, pairs))
    return recorded(*topics, process=replace(LIVING, log=log))


def test_06_words_handled_twice() -> None:
    heard = [[1, word] for word in range(1, 21)]
    verdict = judged("06_spinning", "words_handled", pumped(["begin 1"], heard=[*heard, [1, 1]]))
    refused_for("words-handled.more-than-once", verdict, "21 words handled, but only 20 were sent")


def test_06_no_slow_job_begun() -> None:
    verdict = judged("06_spinning", "slow_callbacks", pumped(["begin 6", "end 6 0.801"], job_begun=[]))
    refused_for("slow-callbacks.none-begun", verdict)


def test_06_a_call_after_one_that_never_came_back() -> None:
    refused_for("call.never-begun", judged("06_spinning", "again", pumped(["begin 1"])))


TRACEBACK = (
    'Traceback (most recent call last):\n  File "/answers/answer.py", line 7, in pump\n    spin(node)\n'
    "NameError: name 'spin' is not defined\n"
)


@pytest.mark.parametrize(
    ("log", "cause", "words"),
    [
        ("", "pump.raises", "pump raised NameError"),
        (TRACEBACK, "error.name-not-defined", "line 7: pump raised NameError"),
    ],
    ids=["unlogged", "logged"],
)
def test_06_the_first_call_raises(log: str, cause: str, words: str) -> None:
    verdict = judged("06_spinning", "program_runs", pumped(["begin 1", "raised 1 NameError: x"], log))
    refused_for(cause, verdict, words)


def test_11_a_little_late_on_a_busy_machine() -> None:
    made = load_exercise("11_polling_against_callbacks", ROOT).criteria[-1].judge.__globals__
    moments, numbers = made["MOMENTS"], made["NUMBERS"]
    said = tuple(Said("/robot/touch", at, at, {"data": n}) for at, n in zip(moments, numbers, strict=True))
    late = on_topic("/monitor/seen", "std_msgs/msg/Int32", [at + 0.02 for at in moments], numbers)
    busy = replace(recorded(late), said=said, in_line_s=0.3)
    verdict = judged("11_polling_against_callbacks", "quick", busy)
    refused_for("quick.busy-machine", verdict, "waited 0.3 s for a processor")
    assert verdict.cause.endswith(BUSY_MACHINE)
    calm = judged("11_polling_against_callbacks", "quick", replace(busy, in_line_s=0.01))
    refused_for("quick.held-back", calm)


def test_07_what_the_node_reports_while_it_is_called_is_its_own() -> None:
    """A thread of the node may report between two calls of the driver."""
    made = load_exercise("07_typed_nodes", ROOT).criteria[-1].judge.__globals__
    moments = [1.0, 2.0, 2.62, 2.63, 2.64, 3.6]
    battery = on_topic("/robot/battery", FLOAT, moments, [99.875, 99.75, 42.0, 99.625, 55.2, 99.5])
    status = on_topic("/robot/status", TEXT, [2.62, 2.63], ["operational", "error"])
    seen = recorded(battery, status, on_topic("/driver/report", TEXT, [2.7], [""]))
    own = made["by_itself"](replace(seen, said=(Said("/driver/go", 2.6, 2.6, {"data": "go"}),)))
    assert [one.value["data"] for one in own.topic("/robot/battery").arrivals] == [
        99.875,
        99.75,
        99.625,
        99.5,
    ]
    assert [one.value["data"] for one in own.topic("/robot/status").arrivals] == ["operational"]
