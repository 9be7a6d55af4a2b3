"""The nodes of lesson 12: their responses, which of them hang, and how they end."""

from pathlib import Path

import pytest
from std_srvs.srv import SetBool, Trigger

from lesson_nodes import heart_and_question, self_test_server, waves_when_asked
from tests.lesson_nodes.ending import ended_well
from workbook.lesson import arrivals, record, start
from workbook.programs.spec import ProgramSpec
from workbook.recording.plan import Plan
from workbook.recording.recording import CallSeen, Recording
from workbook.recording.script import Calls, Script, calls
from workbook.watching.observer import Observer
from workbook.watching.watch import Watch

HEART, ASKED, ANSWERED = "/robot/heartbeat", "/robot/asked", "/robot/answered"
PERIODS = {HEART: 0.1, ASKED: 0.5, ANSWERED: 0.5}
JOINTS = "/robot/joint_positions"
PATIENCE_S = 10.0
MOST_RUNS = 3
"""A node that hangs asks once. If the machine is busy, it may ask before the recorder has discovered its publisher."""


def watched(program: object, script: Script, seconds: float, *topics: str, **parameters: object) -> Recording:
    """Return what a lesson node does, and how it ends on Ctrl-C."""
    plan = Plan(topics, 0.05, 1.0, wall_seconds=seconds, script=script)
    spec = ProgramSpec(Path(str(program.__file__)), parameters=parameters)  # type: ignore[attr-defined]
    with Observer() as observer, Watch(observer, spec, plan, "wall") as watch:
        return watch.finish(watch.observe(), PATIENCE_S)


def called(program: object, one: Calls, seconds: float, *topics: str, **parameters: object) -> Recording:
    """Return what a lesson node does while it is called."""
    return watched(program, Script((one,)), seconds, *topics, **parameters)


def took(call: CallSeen) -> float | None:
    return None if call.answered_wall is None else call.answered_wall - call.wall


def test_the_robot_waves_while_it_has_been_asked_to() -> None:
    script = calls(
        "/robot/wave", SetBool, [(0.5, {"data": True}), (1.5, {"data": True}), (1.6, {"data": False})]
    )
    recording = called(waves_when_asked, script, 2.5, JOINTS)
    assert [call.response["success"] for call in recording.calls] == [True, False, True]
    assert [call.response["message"] for call in recording.calls] == [
        "I am waving",
        "I was waving already",
        "I am standing still",
    ]
    poses = [(one.t, one.value["data"]) for one in recording.topic(JOINTS).arrivals]
    begins, ends = recording.calls[0].answered_t, recording.calls[2].answered_t
    assert begins is not None and ends is not None
    at_rest = [pose for t, pose in poses if t < begins - 0.1 or t > ends + 0.2]
    assert at_rest
    for pose in at_rest:
        assert pose == pytest.approx(waves_when_asked.AT_REST)
    assert len({tuple(pose) for t, pose in poses if begins + 0.1 < t < ends - 0.1}) > 5
    assert ended_well(recording), recording.process


def test_the_self_test_follows_its_pattern() -> None:
    script = calls("/robot/self_test", Trigger, [(0.2 * number, {}) for number in range(1, 6)])
    recording = called(self_test_server, script, 2.5, pattern="ok, faulty,slow,never", slow_s=0.7)
    answered = [call.response and call.response["success"] for call in recording.calls]
    assert answered == [True, False, True, None, True]
    quick, slow = took(recording.calls[4]), took(recording.calls[2])
    assert quick is not None and slow is not None
    assert slow >= 0.65
    assert recording.calls[4].answered_wall < recording.calls[2].answered_wall  # type: ignore[operator]
    assert ended_well(recording), recording.process


@pytest.mark.parametrize(
    ("way", "group", "threads", "server", "answers"),
    [
        ("call", "default", 4, "elsewhere", False),
        ("call", "own", 1, "elsewhere", False),
        ("call", "own", 4, "elsewhere", True),
        ("call", "own", 4, "same node", False),
        ("call_timeout", "default", 1, "elsewhere", False),
        ("await", "default", 4, "elsewhere", False),
        ("await", "own", 1, "elsewhere", True),
        ("await", "own", 1, "same node", False),
        ("await", "reentrant", 1, "same node", True),
        ("spin_until", "default", 1, "elsewhere", False),
        ("done_callback", "default", 1, "same node", True),
    ],
)
def test_an_answer_needs_a_free_thread_and_a_free_group(
    way: str, group: str, threads: int, server: str, answers: bool
) -> None:
    name = f"'{server}'" if " " in server else server
    for _ in range(MOST_RUNS):
        recording = record(
            heart_and_question,
            PERIODS,
            seconds=2.2,
            clock="wall",
            way=way,
            group=group,
            threads=threads,
            server=name,
        )
        if arrivals(recording, ASKED):
            break
    assert arrivals(recording, ASKED)
    assert (len(arrivals(recording, ANSWERED)) >= 2) is answers
    if way in ("await", "done_callback") and answers:
        assert arrivals(recording, HEART)[-1] > 1.5


@pytest.mark.parametrize("way", ["await", "done_callback"])
def test_a_node_that_does_not_hang_ends_on_ctrl_c(way: str) -> None:
    recording = watched(heart_and_question, Script(), 1.0, *PERIODS, way=way, group="own")
    assert arrivals(recording, ANSWERED)
    assert ended_well(recording), recording.process


def test_who_spins_inside_a_callback_belongs_to_nobody_afterwards() -> None:
    recording = record(
        heart_and_question, PERIODS, seconds=4.0, clock="wall", way="spin_until", group="own", threads=4
    )
    assert len(arrivals(recording, ASKED)) == 1
    assert len(arrivals(recording, ANSWERED)) <= 1, "a busy machine may need longer than it waits"
    assert 0.0 < max(arrivals(recording, HEART)) < recording.watched_s - 1.0


@pytest.mark.parametrize(
    ("program", "parameters", "words"),
    [
        (heart_and_question, {"way": "shout"}, "not 'shout'"),
        (heart_and_question, {"group": "another"}, "not 'another'"),
        (heart_and_question, {"server": "nowhere"}, "not 'nowhere'"),
        (heart_and_question, {"server_takes_s": -0.5}, "not -0.5"),
        (self_test_server, {"pattern": "ok,perhaps"}, "not 'perhaps'"),
        (self_test_server, {"slow_s": 0.0}, "not 0.0"),
    ],
)
def test_what_makes_no_sense_is_refused_in_words(
    program: object, parameters: dict[str, object], words: str
) -> None:
    with pytest.raises(RuntimeError, match=words):
        start(program, **parameters)  # type: ignore[arg-type]
