"""Causes that no wrong answer triggers, on recordings made by hand."""

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest

from tests.criteria.by_hand import LIVING, ended_by_itself, every, on_topic, publisher, recorded
from workbook.criteria import Verdict
from workbook.exercise.definition import load_exercise
from workbook.exercise.inconclusive import BUSY_MACHINE
from workbook.recording.recording import CallSeen, Published, Recording, TopicRecording
from workbook.recording.script import Publishes

ROOT = Path(__file__).resolve().parents[2]
FLOAT, TEXT, NUMBERS = "std_msgs/msg/Float32", "std_msgs/msg/String", "std_msgs/msg/Int32MultiArray"


def judged(stem: str, criterion: str, recording: Recording) -> Verdict:
    """Judge one criterion of an exercise, without the criteria that it needs."""
    return next(one for one in load_exercise(stem, ROOT).criteria if one.id == criterion)(recording)


def refused_for(cause: str, verdict: Verdict, *words: str) -> None:
    assert (verdict.status, verdict.cause) == ("failed", cause), verdict
    assert verdict.expected and verdict.because and verdict.try_this
    for word in words:
        assert word in verdict.saw


def text(name: str, *said: str) -> TopicRecording:
    """Record a topic with one text every 0.1 s."""
    return on_topic(name, TEXT, [0.1 * (n + 1) for n in range(len(said))], said)


def test_01_a_thread_that_spins_raises() -> None:
    log = 'Exception in thread Thread-1:\nTraceback (most recent call last):\n  File "/rclpy/executors.py", line 701\n'
    process = replace(LIVING, end_log=f"arms parked\n{log}")
    verdict = judged("01_the_context", "ends_cleanly", recorded(process=process))
    refused_for("ends-cleanly.thread-raised", verdict, "a traceback from a thread")


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


def of_12(
    answered: Sequence[tuple[float, float | None, bool]], said: Sequence[tuple[float, str]]
) -> Recording:
    """Record exercise 12: calls (when, response time, result), and the messages on the health topic."""
    calls = [
        CallSeen("/robot/self_test", "program", at, at, {})
        if after is None
        else CallSeen("/robot/self_test", "program", at, at, {}, {"success": success}, at + after, at + after)
        for at, after, success in answered
    ]
    told = on_topic("/robot/health", TEXT, [at for at, _ in said], [word for _, word in said])
    beats = every(0.2, 69)
    heart = on_topic("/robot/heartbeat", TEXT, beats, ["alive"] * len(beats))
    return replace(recorded(told, heart), calls=tuple(calls))


def test_12_a_slow_answer_that_is_left_out_is_not_slow_for_a_program_that_told_another_slow_one() -> None:
    asked = [(1.0, 0.0, True), (2.0, 0.7, True), (3.0, 0.7, False), (5.0, 0.0, False), (6.0, 0.0, True)]
    said = [(1.0, "ok"), (2.7, "ok"), (5.0, "faulty"), (6.0, "ok")]
    verdict = judged("12_services", "results_told", of_12(asked, said))
    refused_for("results-told.one-left-out", verdict, "at 3.7 s")
    verdict = judged("12_services", "results_told", of_12(asked, [said[0], *said[2:]]))
    refused_for("results-told.slow-dropped", verdict, "at 2.7 s")


def test_12_slow_answers_that_are_given_up_are_dropped_and_nothing_waits() -> None:
    asked = [(1.0, 0.0, True), (2.0, 0.7, True), (3.0, 0.7, False), (4.0, 0.0, False), (5.0, 0.0, True)]
    said = [(1.0, "ok"), (3.0, "no answer"), (4.0, "no answer"), (4.0, "faulty"), (5.0, "ok")]
    refused_for("results-told.slow-dropped", judged("12_services", "results_told", of_12(asked, said)))


def test_12_a_program_that_tells_a_repeated_answer_does_not_tell_changes_only() -> None:
    asked = [(1.0, 0.0, True), (2.0, 0.0, True), (3.0, None, True), (5.0, 0.0, True), (6.0, 0.0, False)]
    said = [(1.0, "ok"), (2.0, "ok"), (4.0, "no answer"), (6.0, "faulty")]
    verdict = judged("12_services", "results_told", of_12(asked, said))
    refused_for("results-told.one-left-out", verdict, "at 5.0 s")


@pytest.mark.parametrize(
    ("used", "in_line_s", "cause"),
    [
        (0.3, 0.0, "easy-on-processor.wakes-too-often"),
        (0.3, 11.0, "easy-on-processor.wants-more"),
        (2.0, 0.0, "easy-on-processor.never-waits"),
    ],
)
def test_11_a_busy_machine_hides_how_much_a_loop_wants(used: float, in_line_s: float, cause: str) -> None:
    process = replace(LIVING, processor=((1.0, 1.0), (4.0, 1.0 + used)))
    verdict = judged(
        "11_polling_against_callbacks",
        "easy_on_processor",
        replace(recorded(process=process), in_line_s=in_line_s),
    )
    refused_for(cause, verdict)


def test_13_a_line_that_follows_only_while_the_heart_beats() -> None:
    changes = [(-1.0, "error"), (2.0, "operational"), (4.5, "error"), (6.0, "operational")]
    said = tuple(Published("/robot/status", at, at, {"data": word}) for at, word in changes)
    times = every(0.5, 27)
    line = on_topic("/dashboard/line", TEXT, times, ["error" if at < 6.0 else "operational" for at in times])
    verdict = judged("13_qos_and_discovery", "status_follows", replace(recorded(line), published=said))
    refused_for("status-follows.only-sometimes", verdict, 'showed "operational" only after later changes')


def touches_of_11() -> tuple[tuple[Published, ...], list[float], list[int]]:
    """Return what the judge publishes in one run, the times (s), and the numbers."""
    [part] = load_exercise("11_polling_against_callbacks", ROOT).plan.script.parts
    assert isinstance(part, Publishes)
    said = tuple(Published(part.topic, line.at, line.at, line.value) for line in part.lines)
    return said, [one.t for one in said], [one.value["data"] for one in said]


def test_11_a_program_that_ends_in_a_pause_without_touches() -> None:
    said, moments, numbers = touches_of_11()
    seen = on_topic("/monitor/seen", "std_msgs/msg/Int32", moments[:40], numbers[:40])
    for process, cause in ((ended_by_itself(exit=0), "ended"), (LIVING, "stops")):
        recording = replace(recorded(seen, process=process), published=said)
        verdict = judged("11_polling_against_callbacks", "none_missed", recording)
        refused_for(
            f"none-missed.{cause}", verdict, f"no report after touch {numbers[39]}; 20 touches missed"
        )


def test_02_faults_in_another_namespace() -> None:
    faults = TopicRecording("/camera/faults", (publisher(TEXT, "/robot/camera"),))
    verdict = judged("02_nodes", "shared_faults", recorded(faults))
    refused_for("shared-faults.other-name", verdict, "other publishers are on /camera/faults")


def test_03_a_float_raises() -> None:
    report = text("/driver/report", "call 1: publish_level(87.25)", "call 1 raised KeyError: 'level'")
    verdict = judged("03_publishers_and_messages", "floats_arrive", recorded(report))
    refused_for("number.raised", verdict, "publish_level(87.25) raised KeyError: 'level'")


Call = tuple[str, str, list[float], list[float]]
WELL: list[Call] = [("87.25", "returned", [87.25], []), ("99.9", "returned", [99.9], [])]


def calls(*made: Call, uncalled: Sequence[float] = ()) -> Recording:
    """Record calls of publish_level: the argument, how the call ended, and the messages during and after it."""
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
    refused_for("floats-arrive.uncalled", verdict, "50.0 was published before")


def test_03_a_call_of_which_a_report_got_lost_is_not_judged() -> None:
    recording = calls(*WELL, ("0.1", "returned", [0.1], []))
    said = recording.topic("/driver/report")
    lost = replace(said, arrivals=tuple(one for one in said.arrivals if "(99.9)" not in one.value["data"]))
    recording = replace(recording, topics={**recording.topics, lost.name: lost})
    assert judged("03_publishers_and_messages", "floats_arrive", recording).ok


def monitor(*readings: float) -> Recording:
    """Record a monitor that created its publisher while readings were already arriving, and that relayed these."""
    seen = on_topic("/monitor/battery", FLOAT, [0.1 * n for n in range(len(readings))], readings)
    late = replace(seen, publishers=tuple(replace(one, first_seen=2.0) for one in seen.publishers))
    said = [(0.5 + 0.1 * n, level) for n, level in enumerate((52.0, 50.25, 49.5, 49.25))]
    return replace(
        recorded(late),
        published=tuple(Published("/robot/battery", at, at, {"data": level}) for at, level in said),
    )


def test_04_a_late_publisher_loses_everything() -> None:
    refused_for(
        "in-order.publisher-made-late", judged("04_subscriptions_and_callbacks", "passes_on", monitor())
    )


def test_04_a_late_publisher_loses_the_first_reading() -> None:
    verdict = judged("04_subscriptions_and_callbacks", "in_order", monitor(50.25, 49.5, 49.25))
    refused_for("in-order.first-ones-lost", verdict, "3 of 4", "52 %")


def pumped(announced: Sequence[str], log: str = "", **told: Sequence[list[int]]) -> Recording:
    """Record what the driver of 06 announced, and what the robot published on its topics."""
    topics: list[TopicRecording] = [text("/driver/pump", *announced)]
    for name, pairs in told.items():
        times = [0.1 * n for n in range(len(pairs))]
        topics.append(on_topic(f"/robot/{name}", NUMBERS, times, pairs))
    return recorded(*topics, process=replace(LIVING, log=log))


def test_06_words_handled_twice() -> None:
    heard = [[1, word] for word in range(1, 21)]
    recording = pumped(["begin 1"], heard=[*heard, [1, 1]])
    recording = replace(
        recording, published=tuple(Published("/robot/words", 0.5, 0.5, {"data": word}) for _, word in heard)
    )
    verdict = judged("06_spinning", "words_handled", recording)
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
    said, moments, numbers = touches_of_11()
    late = on_topic("/monitor/seen", "std_msgs/msg/Int32", [at + 0.02 for at in moments], numbers)
    busy = replace(recorded(late), published=said, in_line_s=0.3)
    verdict = judged("11_polling_against_callbacks", "quick", busy)
    refused_for("quick.busy-machine", verdict, "waited 0.3 s for a processor")
    assert verdict.cause.endswith(BUSY_MACHINE)
    calm = judged("11_polling_against_callbacks", "quick", replace(busy, in_line_s=0.01))
    refused_for("quick.held-back", calm)


def test_07_what_the_node_reports_while_it_is_called_is_its_own() -> None:
    """A thread of the node may publish between two of the driver's calls."""
    made = load_exercise("07_typed_nodes", ROOT).criteria[-1].judge.__globals__
    moments = [1.0, 2.0, 2.62, 2.63, 2.64, 3.6]
    battery = on_topic("/robot/battery", FLOAT, moments, [99.875, 99.75, 42.0, 99.625, 55.2, 99.5])
    status = on_topic("/robot/status", TEXT, [2.62, 2.63], ["operational", "error"])
    seen = recorded(battery, status, on_topic("/driver/report", TEXT, [2.7], [""]))
    own = made["Use"](replace(seen, published=(Published("/driver/go", 2.6, 2.6, {"data": "go"}),))).own
    assert [one.value["data"] for one in own.topic("/robot/battery").arrivals] == [
        99.875,
        99.75,
        99.625,
        99.5,
    ]
    assert [one.value["data"] for one in own.topic("/robot/status").arrivals] == ["operational"]
