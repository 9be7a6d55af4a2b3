"""Each word of the vocabulary on recordings made by hand: right verdict, the student's numbers, full sentences."""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import pytest
from std_msgs.msg import Float32, Float32MultiArray, String

import workbook.criteria as see
from tests.criteria.by_hand import LIVING, ended_by_itself, every, on_topic, publisher, recorded
from workbook.criteria import Topic, Verdict, topic
from workbook.recording.recording import ProcessRecord, Recording, TopicRecording

FLOAT, ARRAY, TEXT = "std_msgs/msg/Float32", "std_msgs/msg/Float32MultiArray", "std_msgs/msg/String"
BATTERY = topic("/robot/battery", Float32, hz=0.5)
JOINTS = topic("/robot/joint_positions", Float32MultiArray, hz=0.5)
STATUS = topic("/robot/status", String, hz=1.0)
EVEN = every(2.0, 7)
TRACEBACK = (
    'Traceback (most recent call last):\n  File "/answers/answer.py", line 7, in <module>\n    main()\n'
    "NameError: name 'Float32' is not defined\n"
)
OVERTAKEN = (  # in the words of this rclpy; test_known_errors.py checks real errors
    'Traceback (most recent call last):\n  File "/answers/answer.py", line 60, in main\n    rclpy.try_shutdown()\n'
    '  File "/site-packages/rclpy/utilities.py", line 100, in try_shutdown\n    g_default_context.try_shutdown()\n'
    '  File "/site-packages/rclpy/context.py", line 139, in try_shutdown\n    self.__context.shutdown()\n'
    "rclpy._rclpy_pybind11.RCLError: failed to shutdown: rcl_shutdown already called on the given context\n"
)


def said(verdict: Verdict) -> str:
    return " | ".join((verdict.saw, verdict.expected, verdict.because, verdict.try_this))


def refuses(verdict: Verdict, *words: str, about_time: bool = False) -> None:
    """Check that the verdict fails, contains these words, and leaves no part of its advice empty."""
    assert not verdict.ok, verdict
    assert all((verdict.saw, verdict.expected, verdict.because, verdict.try_this)), verdict
    assert verdict.about_time is about_time, verdict
    assert verdict.share == 0.0
    for word in words:
        assert word in said(verdict), f"{word!r} is not in: {said(verdict)}"


def accepts(verdict: Verdict, *words: str) -> None:
    assert verdict.ok, verdict
    assert verdict.share == 1.0
    for word in words:
        assert word in verdict.saw, f"{word!r} is not in: {verdict.saw}"


def battery(
    times: list[float], values: list[Any] | None = None, window: tuple[float, float] = (0.0, 14.0)
) -> Recording:
    return recorded(on_topic(BATTERY.name, FLOAT, times, values, window=window))


def joints(*rows: Any) -> Recording:
    return recorded(on_topic(JOINTS.name, ARRAY, every(2.0, len(rows)), list(rows)))


def status(*words: Any) -> Recording:
    return recorded(on_topic(STATUS.name, TEXT, every(1.0, len(words)), list(words)))


# --- the program as a whole ---------------------------------------------------------------------------------


def silent(process: ProcessRecord, *, nodes: bool = False) -> Recording:
    return recorded(process=process, nodes=nodes)


def test_a_publisher_on_the_graph_is_a_program_that_runs() -> None:
    accepts(see.program_runs(battery(EVEN)), "/humanoid")


@pytest.mark.parametrize(
    ("process", "nodes", "words"),
    [
        (replace(LIVING, domains_used=(42,)), False, ("domain 42", "ROS_DOMAIN_ID")),
        (ended_by_itself(TRACEBACK), False, ("line 7", "NameError", "Float32")),
        (ended_by_itself("", 3), False, ("2.5 s", "exit code 3", "rclpy.spin(node)")),
        (ended_by_itself(signal="SIGSEGV"), False, ("signal SIGSEGV", "compiled code")),
        (ended_by_itself(signal="SIGABRT"), False, ("signal SIGABRT", "os.abort()")),
        (ended_by_itself(signal="SIGKILL"), False, ("signal SIGKILL", "no memory was left")),
        (ended_by_itself(signal="SIGXCPU"), False, ("signal SIGXCPU", "processor time")),
        (ended_by_itself(signal="SIGALRM"), False, ("signal SIGALRM", "alarm")),
        (
            ended_by_itself("Expected RMW implementation identifier of 'x'", 102),
            False,
            ("RMW_IMPLEMENTATION",),
        ),
        (replace(LIVING, limits_hit=("output",)), False, ("50 MB", "endless loop")),
        (replace(LIVING, limits_hit=("memory",)), False, ("2.5 GB", "stopped")),
        (replace(LIVING, limits_hit=("files",)), False, ("20,000 files", "stopped")),
        (replace(LIVING, domains_used=(17,)), False, ("can be found", "ROS_AUTOMATIC_DISCOVERY_RANGE")),
        (replace(LIVING, domains_used=(17, 42)), False, ("can be found", "ROS_AUTOMATIC_DISCOVERY_RANGE")),
        (LIVING, True, ("/humanoid", "no publisher at all", "create_publisher")),
        (LIVING, False, ("none of its nodes", "8.0 s")),
    ],
    ids=[
        *(
            "other domain",
            "traceback",
            "ends",
            "crashes",
            "aborts",
            "killed",
            "processor time",
            "another signal",
        ),
        *(
            "other middleware",
            "floods",
            "takes memory",
            "makes files",
            "hides",
            "hides, and is elsewhere, too",
        ),
        *("no publisher", "never appears"),
    ],
)
def test_a_program_that_is_not_seen_is_told_why(
    process: ProcessRecord, nodes: bool, words: tuple[str, ...]
) -> None:
    refuses(see.program_runs(silent(process, nodes=nodes)), *words)


IN_A_CALLBACK = (
    "Traceback (most recent call last):\n"
    '  File "/answers/answer.py", line 40, in <module>\n    rclpy.spin(node)\n'
    '  File "/env/site-packages/rclpy/executors.py", line 825, in spin_once\n    raise handler.exception()\n'
    '  File "/answers/answer.py", line 7, in tick\n    self.publish(Flaot32())\n'
    "NameError: name 'Flaot32' is not defined\n"
)


@pytest.mark.parametrize("arrived", range(4))
def test_what_still_arrived_before_a_callback_failed_does_not_decide(arrived: int) -> None:
    seen = on_topic(BATTERY.name, FLOAT, every(0.5, arrived))
    gone = replace(seen, publishers=tuple(replace(one, last_seen=2.4) for one in seen.publishers))
    accepts(see.program_runs(recorded(gone, process=ended_by_itself(IN_A_CALLBACK))))


@pytest.mark.parametrize("arrived", range(2))
def test_a_callback_that_fails_before_the_node_can_be_seen_is_a_start_that_failed(arrived: int) -> None:
    seen = on_topic(BATTERY.name, FLOAT, every(0.1, arrived))
    brief = replace(recorded(seen, process=ended_by_itself(IN_A_CALLBACK)), watched_s=0.3)
    refuses(see.program_runs(brief), "NameError")


@pytest.mark.parametrize("arrived", range(2))
def test_a_program_that_fails_in_its_first_lines_does_not_run(arrived: int) -> None:
    seen = on_topic(BATTERY.name, FLOAT, every(0.5, arrived))
    refuses(see.program_runs(recorded(seen, process=ended_by_itself(TRACEBACK))), "NameError")


def test_the_judges_own_domain_is_no_stranger() -> None:
    verdict = see.program_runs(silent(replace(LIVING, domains_used=(17,))))
    assert "domain" not in verdict.saw


def beside(seen: TopicRecording, **broken: Any) -> Recording:
    return recorded(replace(seen, **broken))


@pytest.mark.parametrize("word", [see.rate, see.counts, partial(see.length, wanted=1)])
def test_messages_that_nobody_can_read_are_heeded_beside_right_ones(word: Callable[..., Verdict]) -> None:
    right = on_topic(BATTERY.name, FLOAT, EVEN, [[0.5]] * len(EVEN))
    assert word(recorded(right), BATTERY).ok
    garbled = word(beside(right, undecodable=2, broken_at=3.0), BATTERY)
    refuses(garbled, "7 readable messages", "but also 2 that could not be decoded", "the first at 3.0 s")
    assert garbled.cause == "all-kept.undecodable"
    large = word(beside(right, not_kept=1, too_large=1, broken_at=3.0), BATTERY)
    refuses(large, "7 readable messages", "but also 1 larger than 4 MB", "the first at 3.0 s")
    assert large.cause == "all-kept.too-large"


def test_more_messages_than_are_kept_are_heeded_once_those_are_right() -> None:
    right = on_topic(BATTERY.name, FLOAT, EVEN, [[0.5]] * len(EVEN))
    full_at = EVEN[-1] + BATTERY.period
    full = beside(right, not_kept=9, full_at=full_at, room=4_000_000)
    for verdict in (see.rate(full, BATTERY), see.length(full, BATTERY, 1)):
        refuses(verdict, "4 MB", f"{len(EVEN)} messages", "ignored the rest")
        assert verdict.cause == "all-kept.too-much"
    refuses(see.length(full, BATTERY, 2), "1 value")
    fast = on_topic(BATTERY.name, FLOAT, every(0.01, 200))
    too_fast = see.rate(beside(fast, not_kept=9, full_at=2.01), BATTERY)
    assert too_fast.cause == "rate.too-fast", (
        "until then it came far too often; what came later, nobody knows"
    )
    nothing = see.no_message(
        beside(on_topic(BATTERY.name, FLOAT), not_kept=1, full_at=0.5, room=100), BATTERY
    )
    assert nothing is not None and nothing.cause == "all-kept.too-much"


def test_alive_at_end() -> None:
    accepts(see.alive_at_end(battery(EVEN)), "8.0 s")
    simulated = replace(battery(EVEN), clock="simulated", watched_s=26.0)
    accepts(see.alive_at_end(simulated), "after 26.0 s of robot time")
    refuses(
        see.alive_at_end(silent(ended_by_itself("", 0))), "ended by itself after 2.5 s", "exit code 0", "spin"
    )
    refuses(see.alive_at_end(silent(ended_by_itself(TRACEBACK))), "2.5 s", "line 7", "NameError")


@pytest.mark.parametrize(
    ("limit", "words"),
    [
        ("output", "printed"),
        ("processes", "processes"),
        ("memory", "memory"),
        ("files", "files"),
        ("disk", "wrote"),
    ],
)
def test_a_program_that_was_stopped_for_a_limit_is_not_alive(limit: str, words: str) -> None:
    stopped = replace(LIVING, exit=None, signal="SIGKILL", limits_hit=(limit,))
    refuses(see.alive_at_end(silent(stopped)), "stopped after 8.0 s", words)


def test_a_limit_that_a_program_met_and_survived_does_not_end_it() -> None:
    accepts(see.alive_at_end(silent(replace(LIVING, limits_hit=("open_files",)))), "8.0 s")


def test_an_end_by_a_signal_is_named() -> None:
    refuses(see.alive_at_end(silent(ended_by_itself(signal="SIGABRT"))), "2.5 s", "SIGABRT", "executor")


def test_exits_cleanly() -> None:
    accepts(see.exits_cleanly(silent(LIVING)), "exit code 0")
    refuses(see.exits_cleanly(silent(ended_by_itself("", 0))), "before Ctrl-C", "2.5 s")
    refuses(see.exits_cleanly(silent(replace(LIVING, exit=None, signal="SIGKILL"))), "had to be killed")
    refuses(see.exits_cleanly(silent(replace(LIVING, exit=None, signal="SIGABRT"))), "SIGABRT", "thread")
    refuses(
        see.exits_cleanly(silent(replace(LIVING, exit=None, signal="SIGSEGV"))),
        "SIGSEGV",
        "Run the check again",
    )
    uncaught = replace(LIVING, exit=130, end_log="Traceback (most recent call last):\nKeyboardInterrupt\n")
    refuses(see.exits_cleanly(silent(uncaught)), "exit code 130", "KeyboardInterrupt")
    refuses(
        see.exits_cleanly(silent(replace(uncaught, exit=0))), "exit code 0", "prints the traceback itself"
    )
    refuses(see.exits_cleanly(silent(replace(LIVING, exit=3))), "exit code 3", "sys.exit()")
    by_signal = replace(LIVING, exit=None, signal="SIGINT")
    refuses(see.exits_cleanly(silent(by_signal)), "signal SIGINT after Ctrl-C", "KeyboardInterrupt")
    refuses(see.exits_cleanly(silent(replace(LIVING, exit=1, end_log=TRACEBACK))), "line 7", "NameError")
    refuses(
        see.exits_cleanly(silent(replace(LIVING, exit=1, end_log=OVERTAKEN))),
        "while rclpy is still spinning",
        "starts your program again",
    )
    interrupted = (
        'Traceback (most recent call last):\n  File "/answers/answer.py", line 7\nKeyboardInterrupt\n\n'
    )
    uncaught = replace(LIVING, exit=1, end_log=interrupted + OVERTAKEN)
    refuses(see.exits_cleanly(silent(uncaught)), "exit code 1", "nothing catches it")
    also = OVERTAKEN + "\nDuring handling of the above exception, another exception occurred:\n\n" + TRACEBACK
    refuses(see.exits_cleanly(silent(replace(LIVING, exit=1, end_log=also))), "line 7", "NameError")
    refuses(see.exits_cleanly(silent(replace(LIVING, exit=2, end_log=OVERTAKEN))), "already called")
    with pytest.raises(ValueError, match="to_the_end"):
        see.exits_cleanly(silent(replace(LIVING, exit=None, ended_by=None)))


# --- topics -------------------------------------------------------------------------------------------------


def test_publishes_the_right_type() -> None:
    accepts(see.publishes(battery(EVEN), BATTERY), "/robot/battery carries Float32")


def test_publishes_tells_the_type_that_is_there() -> None:
    refuses(see.publishes(recorded(on_topic(BATTERY.name, TEXT)), BATTERY), "carries String", "std_msgs.msg")


def test_publishes_refuses_two_types_on_one_name() -> None:
    both = replace(on_topic(BATTERY.name, FLOAT), publishers=(publisher(FLOAT), publisher(TEXT)))
    refuses(see.publishes(recorded(both), BATTERY), "two types", TEXT)


def other(name: str, node: str = "/humanoid", kind: str = ARRAY) -> TopicRecording:
    return on_topic(name, kind, node=node)


@pytest.mark.parametrize(
    ("seen", "words"),
    [
        (other("/robot/Joint_Positions"), ("/robot/Joint_Positions", "case-sensitive")),
        (other("/joint_positions"), ("/joint_positions", "namespace /robot is missing")),
        (other("/lab/robot/joint_positions"), ("namespace /lab", "relative name")),
        (other("/humanoid/joint_positions"), ("/humanoid/joint_positions", "~")),
        (other("/robot/joint_angles"), ("/robot/joint_angles", "letter by letter")),
        (other("/robot/joint_angles", node="/robot"), ("/robot/joint_angles", "letter by letter")),
        (other("/robot/jointpositions"), ("/robot/jointpositions", "'/robot/joint_positions'")),
        (
            other("/temperature", kind=FLOAT),
            ("nothing on /robot/joint_positions", "publishes on /temperature"),
        ),
        (other("/driver/joint_positions"), ("your program publishes on no topic",)),
    ],
    ids=[
        "case",
        "no namespace",
        "more namespace",
        "private",
        "other word",
        "node named like a namespace",
        "near",
        "none like it",
        "driver",
    ],
)
def test_publishes_says_what_was_published_instead(seen: TopicRecording, words: tuple[str, ...]) -> None:
    refuses(see.publishes(recorded(seen), JOINTS), *words)


def test_publishes_blames_the_error_in_the_log_when_no_name_is_near() -> None:
    recording = recorded(other("/temperature", kind=FLOAT), process=ended_by_itself(TRACEBACK))
    refuses(see.publishes(recording, JOINTS), "line 7", "NameError")


def test_no_message() -> None:
    assert see.no_message(battery([2.0]), BATTERY) is None
    silence = see.no_message(battery([]), BATTERY)
    assert silence is not None
    refuses(silence, "no message arrived in 14.0 s", "create a timer".capitalize(), about_time=True)
    large = see.no_message(recorded(on_topic(BATTERY.name, FLOAT, not_kept=2)), BATTERY)
    assert large is not None
    refuses(large, "2 messages", "larger than 4 MB")
    garbled = see.no_message(recorded(on_topic(BATTERY.name, FLOAT, undecodable=3)), BATTERY)
    assert garbled is not None
    refuses(garbled, "3 messages", "could not be decoded")
    crashed = see.no_message(
        recorded(on_topic(BATTERY.name, FLOAT), process=ended_by_itself(TRACEBACK)), BATTERY
    )
    assert crashed is not None
    refuses(crashed, "line 7", "NameError", about_time=True)


@pytest.mark.parametrize(
    "word",
    [
        lambda recording: see.rate(recording, BATTERY),
        lambda recording: see.counts(recording, BATTERY),
        lambda recording: see.length(recording, BATTERY, 12),
        lambda recording: see.finite(recording, BATTERY),
        lambda recording: see.within(recording, BATTERY, 0.0, 1.0),
        lambda recording: see.varies(recording, BATTERY, 1, 0.1),
        lambda recording: see.one_of(recording, BATTERY, {"operational"}),
        lambda recording: see.never_rises(recording, BATTERY),
    ],
)
def test_silence_fails_every_word_and_is_about_time(word: Callable[[Recording], Verdict]) -> None:
    refuses(word(battery([])), "no message", about_time=True)
    refuses(word(recorded()), "no message", about_time=True)


# --- rates --------------------------------------------------------------------------------------------------


def test_rate_accepts_its_whole_tolerance() -> None:
    accepts(see.rate(battery(EVEN), BATTERY), "0.5 Hz", "7 messages")
    accepts(see.rate(battery(every(1.7, 8)), BATTERY), "0.59 Hz")
    accepts(see.rate(battery(every(2.4, 5)), BATTERY), "0.42 Hz")


@pytest.mark.parametrize(
    ("times", "words"),
    [
        (every(0.5, 27), ("2 Hz", "0.5 s", "27 messages", "Period and frequency are swapped")),
        (every(0.2, 70), ("5 Hz", "about 10 times the expected rate")),
        (every(4.0, 3), ("0.25 Hz", "3 messages", "too low")),
        ([1.0, 5.0, 9.0], ("0.25 Hz", "3 messages", "too low")),
        (every(2.9, 4), ("0.34 Hz", "too low", "create_timer(2.0, ...)")),
        ([2.0], ("a single message in 14.0 s", "published once")),
        ([2.0, 2.0], ("2 messages at one moment",)),
        (sorted(EVEN * 2), ("messages arrive in pairs", "Two timers")),
        (sorted(EVEN * 3), ("groups of 3",)),
        ([2.0, 4.0], ("the last of 2 messages arrived at 4.0 s", "nothing until 14.0 s", "stops")),
        ([2.0, 4.0, 8.5, 10.0, 12.0, 14.0], ("a gap of 4.5 s starting at 4.0 s", "never sleep")),
        ([5.0, 7.0, 9.0, 11.0, 13.0], ("a gap of 5.0 s before the first message",)),
    ],
    ids=[
        "swapped",
        "fast",
        "slow",
        "slow, and the next one is due when the watch ends",
        "a bit slow",
        "once",
        "at the same time",
        "pairs",
        "triples",
        "stops",
        "blocks",
        "late",
    ],
)
def test_rate_refuses_with_the_numbers_of_the_student(times: list[float], words: tuple[str, ...]) -> None:
    refuses(see.rate(battery(times), BATTERY), *words, about_time=True)


@pytest.mark.parametrize("word", [see.rate, see.counts])
def test_rates_faster_than_the_steps_of_simulated_time_are_not_told_as_a_number(word: Any) -> None:
    measured = replace(battery(every(0.2, 70)), step_s=0.1)
    refuses(word(measured, BATTERY), "5 Hz", "about 10 times the expected rate", about_time=True)
    verdict = word(replace(battery(every(0.1, 140)), step_s=0.1), BATTERY)
    refuses(verdict, "faster than 5 Hz", "far above the expected rate", about_time=True)
    assert "10 Hz" not in said(verdict) and "factor" not in said(verdict)


def test_rate_needs_more_than_three_messages() -> None:
    refuses(
        see.rate(battery([2.0, 4.0, 6.0], window=(0.0, 7.0)), BATTERY), "only 3 messages", about_time=True
    )


def test_rate_does_not_tell_what_simulated_time_cannot_resolve() -> None:
    fast = on_topic(BATTERY.name, FLOAT, every(0.1, 140))
    refuses(
        see.rate(recorded(fast, clock="simulated"), BATTERY),
        "faster than 5 Hz",
        "far above the expected rate",
        about_time=True,
    )


def test_rate_in_simulated_time_forgives_one_step_of_the_clock() -> None:
    times = [2.0, 4.0, 7.05, 9.0, 11.0, 13.0]
    refuses(see.rate(battery(times), BATTERY), "a gap of 3.0 s", about_time=True)
    accepts(see.rate(recorded(on_topic(BATTERY.name, FLOAT, times), clock="simulated"), BATTERY))


def test_the_window_of_a_late_topic_is_what_counts() -> None:
    accepts(see.rate(battery([8.0, 10.0, 12.0, 14.0], window=(6.5, 14.0)), BATTERY))


def test_counts_are_exact_but_for_the_edge() -> None:
    for count in (6, 7, 8):
        accepts(see.counts(battery(every(1.5, count)), BATTERY), f"{count} messages")
    refuses(
        see.counts(battery(every(1.5, 9)), BATTERY), "9 messages in 14.0 s", "7 messages", about_time=True
    )
    refuses(see.counts(battery(every(1.5, 5)), BATTERY), "5 messages", about_time=True)


# --- values -------------------------------------------------------------------------------------------------


def test_length() -> None:
    accepts(see.length(joints([0.0] * 12, [1.0] * 12), JOINTS, 12), "12 values in each of 2 messages")
    refuses(
        see.length(joints([0.0] * 11, [0.0] * 11), JOINTS, 12),
        "every message has 11 values",
        "off-by-one",
    )
    refuses(see.length(joints([0.0] * 12, [0.0] * 13), JOINTS, 12), "1 of 2 messages has 13 values")
    refuses(see.length(joints([], [0.0] * 12), JOINTS, 12), "0 values", "before its data was set")
    refuses(
        see.length(joints([0.0] * 24, [0.0] * 36), JOINTS, 12),
        "the messages have 24 and 36 values",
        "grows with every message",
    )
    refuses(see.length(joints([0.0], [0.0]), JOINTS, 12), "every message has 1 value")
    refuses(see.length(joints({"length": 9000, "first": [0.0] * 4096}), JOINTS, 12), "9000")


def test_finite() -> None:
    accepts(see.finite(joints([0.0, 1.5]), JOINTS), "finite")
    refuses(
        see.finite(joints([0.0, 0.0], [0.0, math.nan], [math.nan] * 2), JOINTS),
        "nan in message 2, element 1",
        "2 messages affected",
    )
    refuses(see.finite(joints([math.inf]), JOINTS), "inf in message 1, element 0", "1 message affected")
    refuses(see.finite(battery([2.0], [math.nan]), BATTERY), "nan in message 1 ")
    refuses(see.finite(status("0.5"), STATUS), "0.5")


def test_within() -> None:
    accepts(
        see.within(joints([-math.pi, math.pi + 5e-7]), JOINTS, -math.pi, math.pi, "rad"),
        "-π to π rad",
    )
    refuses(
        see.within(joints([0.0, 90.0]), JOINTS, -math.pi, math.pi, "rad"),
        "90 rad in message 1, element 1",
        "degrees",
        "math.radians()",
        "max(-math.pi, min(math.pi, value))",  # a rounded bound would itself be out of range
    )
    refuses(see.within(battery([2.0, 4.0], [99.0, -0.5]), BATTERY, 0.0, 100.0, "%"), "-0.5 % in message 2")
    refuses(see.within(battery([2.0], [math.inf]), BATTERY, 0.0, 100.0), "inf", "division by zero")
    accepts(see.within(joints([math.nan]), JOINTS, -math.pi, math.pi))


def test_varies() -> None:
    moving = [[0.1 * n, -0.1 * n, 0.0] for n in range(5)]
    accepts(see.varies(joints(*moving), JOINTS, 2, 1e-6, "joint"), "2 of 3 joints move")
    one = [[0.1 * n, 0.0, 0.0] for n in range(5)]
    refuses(see.varies(joints(*one), JOINTS, 2, 1e-6, "joint"), "only joint 0 moves", "at least 2 joints")
    refuses(see.varies(joints(*[[0.5] * 3] * 5), JOINTS, 2, 1e-6, "joint"), "no joint moves", "outside")
    refuses(see.varies(joints([0.0] * 3), JOINTS, 2, 1e-6), "only one message", about_time=True)
    nan = [[math.nan, 0.1 * n, 0.2 * n] for n in range(5)]
    accepts(see.varies(joints(*nan), JOINTS, 2, 1e-6), "2 of 3")
    accepts(see.varies(joints([], [1.0], [2.0], [3.0]), JOINTS, 1, 1e-6), "1 of 1")


def test_one_of() -> None:
    words = {"operational", "error"}
    accepts(see.one_of(status("operational", "error"), STATUS, words), '"error" and "operational"')
    refuses(see.one_of(status("operational", "ok"), STATUS, words), '"ok"', '"operational" or "error"')
    refuses(see.one_of(status(""), STATUS, words), "The text is empty")


@pytest.mark.parametrize("value", [[0.0, 1.0], {"length": 9000, "first": "o" * 4096}, None, 1.5, True])
def test_text_is_judged_whatever_type_came(value: Any) -> None:
    refuses(see.one_of(status(value), STATUS, {"operational", "error"}), "/robot/status")


def test_never_rises() -> None:
    accepts(see.never_rises(battery(EVEN[:3], [100.0, 99.5, 99.50005]), BATTERY), "100 to 99.5")
    refuses(
        see.never_rises(battery(EVEN[:3], [100.0, 98.0, 98.5]), BATTERY),
        "rises from 98 to 98.5 at message 3",
        "adds to the level",
    )
    accepts(see.never_rises(battery([2.0], [50.0]), BATTERY))


@pytest.mark.parametrize("value", [None, "full", [1.0, 2.0], {"length": 5000, "first": [1.0]}, True, 7])
def test_no_word_crashes_on_values_of_another_kind(value: Any) -> None:
    recording = battery(EVEN[:4], [value] * 4)
    for verdict in (
        see.length(recording, BATTERY, 12),
        see.finite(recording, BATTERY),
        see.within(recording, BATTERY, 0.0, 100.0),
        see.varies(recording, BATTERY, 1, 0.1),
        see.never_rises(recording, BATTERY),
        see.rate(recording, BATTERY),
        see.one_of(recording, BATTERY, {"operational"}),
    ):
        assert verdict.saw


def test_all_of_shows_the_first_that_fails_and_joins_what_holds() -> None:
    good, bad = (
        see.passed("99 %"),
        see.failed("test.rises", "rises", "falls", "the sign", "subtract", about_time=True),
    )
    assert see.all_of(good, see.passed("0.5 Hz")).saw == "99 %; 0.5 Hz"
    assert see.all_of(good, bad, see.failed("test.never", "never shown", "", "", "")) == bad
    in_part = see.partial("test.half", 0.5, "half", "all", "half is missing", "add it")
    assert see.all_of(in_part).status == "failed"
    assert see.all_of(in_part).share == 0.0


@pytest.mark.parametrize("share", [0.0, 1.0, -0.5, 1.5, math.nan])
def test_a_part_is_more_than_nothing_and_less_than_all(share: float) -> None:
    with pytest.raises(ValueError, match="between 0 and 1"):
        see.partial("test.share", share, "", "", "", "")


def test_a_topic_without_a_rate_has_no_period() -> None:
    with pytest.raises(ValueError, match="no rate"):
        _ = Topic("/robot/status", TEXT).period


@pytest.mark.parametrize(
    ("published", "last"), [(0.9, None), (1.0, "near"), (1.9, "near"), (2.0, "clear"), (9.0, "clear")]
)
def test_the_input_before_an_output_is_the_one_that_came_last(published: float, last: str | None) -> None:
    inputs = [(2.0, "far"), (2.0, "clear"), (1.0, "near")]  # two in the same tenth of a millisecond
    assert see.latest_before(inputs, published) == last
