"""Inconclusive judgments: those that take points away for something that may not be the answer's fault."""

import os
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from workbook.authoring.tree import Tree
from workbook.authoring.wrong_answers import read_wrong_answer
from workbook.criteria.runner import CriterionResult, run_criteria
from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.exercise.inconclusive import END_OVERTAKEN, InconclusiveReason, find_inconclusive_reason
from workbook.exercise.judgement import Judgement
from workbook.exercise.judging import Judge
from workbook.exercise.retries import until_sure
from workbook.exercise.source import stems
from workbook.feedback.text import as_text
from workbook.inside.proc import run_queue_s
from workbook.recording.recording import ProcessRecord, Published, PublisherSeen, Recording, TopicRecording
from workbook.ros.domains import lease_domain
from workbook.watching import wall_time, watch
from workbook.watching.observer import Observer
from workbook.watching.session import Session
from workbook.watching.steal_time import StealTime

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
EXERCISE = load_exercise(STEM, ROOT)
JOINTS = "/robot/joint_positions"


def stored(name: str) -> Recording:
    return Recording.load(ROOT / "tests" / "recordings" / STEM / f"{name}.json")


def judged(recording: Recording) -> tuple[CriterionResult, ...]:
    return run_criteria(EXERCISE.criteria, recording)


def inconclusive_reason(recording: Recording, on_simulated_time: tuple[CriterionResult, ...] = ()) -> str:
    found = find_inconclusive_reason(
        judged(recording), recording, EXERCISE.plan, EXERCISE.periods, on_simulated_time
    )
    assert not found.end_only, "nothing of this exercise is about the end"
    return found.reason


def test_full_marks_from_a_watch_that_ended_before_its_script_are_not_final() -> None:
    good = stored("solution")
    assert "before 1 message of the script was sent" in inconclusive_reason(
        replace(good, unpublished=(Published("/robot/imu", 9.0, 9.0, {}),))
    )
    assert inconclusive_reason(good) == ""


@pytest.mark.parametrize(
    "name", ["solution", "eleven_values", "period_for_frequency", "raises_at_once", "starter", "wrong_name"]
)
def test_what_was_well_seen_is_conclusive(name: str) -> None:
    assert inconclusive_reason(stored(name)) == ""


def with_joints(recording: Recording, joints: TopicRecording) -> Recording:
    return replace(recording, topics={**recording.topics, JOINTS: joints})


def test_a_publisher_that_was_never_connected_leaves_a_doubt() -> None:
    good = stored("solution")
    unmatched = with_joints(good, replace(good.topic(JOINTS), arrivals=(), window=None))
    assert "never connected" in inconclusive_reason(unmatched)
    assert JOINTS in inconclusive_reason(unmatched)


def test_a_publisher_that_went_away_or_a_program_that_ended_leaves_none() -> None:
    good = stored("solution")
    joints = replace(good.topic(JOINTS), arrivals=(), window=None)
    gone = replace(joints, publishers=tuple(replace(one, last_seen=3.0) for one in joints.publishers))
    assert inconclusive_reason(with_joints(good, gone)) == ""
    for process in (
        replace(good.process, ended_by="itself", exit=1),
        replace(good.process, ended_by="judge", limits_hit=("output",)),
    ):
        assert inconclusive_reason(replace(with_joints(good, joints), process=process)) == ""


def nothing_seen(**process: Any) -> Recording:
    record = ProcessRecord(program="answer.py", ended_by="judge", watched_for=12.0, **process)
    return Recording(clock="wall", domain_id=17, process=record)


def test_a_node_on_the_domain_that_was_never_seen_leaves_a_doubt() -> None:
    assert "domain 17" in inconclusive_reason(nothing_seen(domains_used=(17,)))


@pytest.mark.parametrize("domains", [(), (30,)])
def test_no_node_at_all_and_a_node_elsewhere_are_conclusive(domains: tuple[int, ...]) -> None:
    assert inconclusive_reason(nothing_seen(domains_used=domains)) == ""


def test_a_node_that_came_and_went_was_seen() -> None:
    publisher = PublisherSeen("/n", "std_msgs/msg/String", "reliable", "volatile", 0.1, last_seen=0.2)
    topics = {JOINTS: TopicRecording(JOINTS, (publisher,))}
    assert inconclusive_reason(replace(nothing_seen(domains_used=(17,)), topics=topics)) == ""


def test_clocks_that_contradict_each_other_leave_a_doubt() -> None:
    slow = replace(stored("period_for_frequency"), clock="wall")
    assert "passed on robot time" in inconclusive_reason(slow, judged(stored("solution")))
    assert inconclusive_reason(slow, judged(stored("period_for_frequency"))) == ""


def test_only_lost_time_is_put_down_to_a_busy_machine() -> None:
    slow = replace(stored("period_for_frequency"), clock="wall", held_up_s=0.6)
    assert "0.60 s" in inconclusive_reason(slow)
    assert inconclusive_reason(replace(slow, held_up_s=0.2)) == ""
    assert inconclusive_reason(replace(slow, clock="simulated")) == "", (
        "simulated time waits for a program that the machine holds up"
    )
    assert inconclusive_reason(replace(stored("eleven_values"), clock="wall", held_up_s=5.0)) == ""
    assert inconclusive_reason(replace(stored("solution"), clock="wall", held_up_s=5.0)) == ""
    taken = replace(slow, held_up_s=0.0, stood_still_s=0.6)
    assert "its host gave one of its processors to others for 0.60 s" in inconclusive_reason(taken)
    assert inconclusive_reason(replace(taken, stood_still_s=0.2)) == ""
    assert Recording.from_json(taken.to_json()).stood_still_s == 0.6
    often = replace(slow, held_up_s=0.0, watched_s=10.0, taken_s=1.6)
    assert "gave its processors to others for 1.6 s of 10 s" in inconclusive_reason(often)
    assert inconclusive_reason(replace(often, taken_s=1.0)) == ""
    assert Recording.from_json(often.to_json()).taken_s == 1.6


def one_late(recording: Recording, topic: str, which: slice, late_s: float) -> Recording:
    """Return the recording as if on the wall clock, with some messages of a topic delayed."""
    arrivals = list(recording.topic(topic).arrivals)
    arrivals[which] = [replace(arrival, t=arrival.t + late_s) for arrival in arrivals[which]]
    late = replace(recording.topic(topic), arrivals=tuple(arrivals))
    return replace(recording, clock="wall", topics={**recording.topics, topic: late})


def test_a_single_late_message_leaves_a_doubt_and_a_wrong_pace_none() -> None:
    good = stored("solution")
    assert "0.70 s late" in inconclusive_reason(one_late(good, "/robot/status", slice(2, 3), 0.7))
    assert "0.70 s late" in inconclusive_reason(one_late(good, "/robot/status", slice(2, None), 0.7))
    assert inconclusive_reason(one_late(good, "/robot/status", slice(None, None, 2), 0.7)) == ""
    assert inconclusive_reason(one_late(stored("period_for_frequency"), "/robot/status", slice(0), 0.0)) == ""
    late = one_late(good, "/robot/status", slice(2, 3), 0.7)
    rates = {name: period for name, period in EXERCISE.periods.items() if name != "/robot/status"}
    assert find_inconclusive_reason(judged(late), late, EXERCISE.plan, rates) == InconclusiveReason(), (
        "no rate was asked for"
    )
    on_simulated_time = one_late(good, "/robot/status", slice(2, 3), 0.7)
    assert inconclusive_reason(replace(on_simulated_time, clock="simulated")) == ""


def test_a_long_pause_is_no_late_message_unless_the_machine_kept_it() -> None:
    paused = one_late(stored("solution"), "/robot/status", slice(2, None), 3.0)
    assert inconclusive_reason(paused) == ""
    assert "3.00 s late" in inconclusive_reason(replace(paused, held_up_s=0.05, watched_s=100.0, taken_s=3.1))


class Stumbling:
    """A watch whose pauses last much longer than requested, as on a machine without a free CPU."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, seconds: float) -> None:
        original = wall_time.sleep
        self.left = seconds

        def pause(asked: float) -> None:
            original(asked)
            more, self.left = self.left, 0.0
            original(more)

        monkeypatch.setattr(wall_time, "sleep", pause)


def judge_on_the_wall_clock(text: str) -> Judgement:
    on_the_wall = replace(EXERCISE, plan=replace(EXERCISE.plan, wall_seconds=3.0))
    object.__setattr__(on_the_wall, "source", replace(EXERCISE.source, clock="wall"))
    with Observer() as observer:
        return Judge(observer).judge(on_the_wall, Answer(text))


def test_a_program_that_got_no_processor_leaves_everything_it_did_in_doubt() -> None:
    eleven = replace(stored("eleven_values"), clock="wall", watched_s=9.0, in_line_s=1.2)
    assert "waited for a processor for 1.2 s of 9 s" in inconclusive_reason(eleven)
    assert inconclusive_reason(replace(eleven, in_line_s=0.6)) == ""
    late = replace(stored("period_for_frequency"), clock="wall", watched_s=9.0, in_line_s=0.6)
    assert "waited for a processor for 0.6 s of 9 s" in inconclusive_reason(late), (
        "where time was lost, less is enough"
    )
    assert inconclusive_reason(replace(late, in_line_s=0.4)) == ""
    assert inconclusive_reason(replace(eleven, clock="simulated")) == ""
    assert inconclusive_reason(replace(stored("solution"), clock="wall", watched_s=9.0, in_line_s=1.2)) == ""
    crashed = stored("raises_at_once")
    assert crashed.process.exit == 1
    assert inconclusive_reason(replace(crashed, clock="wall", watched_s=0.5, in_line_s=0.1)) == ""


def test_a_criterion_may_blame_the_machine() -> None:
    recording = stored("period_for_frequency")
    lost = [
        replace(one, cause="quick.busy-machine") if one.status == "failed" else one
        for one in judged(recording)
    ]
    assert "so busy" in find_inconclusive_reason(lost, recording, EXERCISE.plan, EXERCISE.periods).reason


def test_how_long_a_process_stood_in_line() -> None:
    """Two processes that compete for one CPU get half of it each."""
    [core, *_] = os.sched_getaffinity(0)
    greedy = [
        sys.executable,
        "-c",
        f"import os; os.sched_setaffinity(0, [{core}]); print(1, flush=True)\nwhile 1: 0",
    ]
    with subprocess.Popen(greedy, stdout=subprocess.PIPE) as one, subprocess.Popen(greedy) as other:
        try:
            assert one.stdout is not None
            one.stdout.readline()
            deadline = time.monotonic() + 60.0
            while run_queue_s(one.pid) < 0.5:
                assert time.monotonic() < deadline
                time.sleep(0.05)
        finally:
            one.kill()
            other.kill()
    assert run_queue_s(one.pid) == 0.0, "it has ended"


def wrong_program(name: str) -> str:
    tree = Tree(ROOT)
    return read_wrong_answer(tree, tree.wrong_answers / STEM / f"{name}.py").answer.text


def test_a_watch_knows_of_a_processor_that_was_taken_away(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(StealTime, "longest_since_last", lambda _: 0.7)
    wrong = wrong_program("period_for_frequency")
    judgement = judge_on_the_wall_clock(wrong)
    assert judgement.recording is not None
    assert judgement.recording.stood_still_s == 0.7
    assert judgement.inconclusive_reason


def test_a_watch_knows_how_long_it_was_held_up(monkeypatch: pytest.MonkeyPatch) -> None:
    original = wall_time.run_wall_time
    stumbling = Stumbling(monkeypatch, 0.0)

    def run(session: Session, seconds: float, cancel_soak: Callable[[], bool]) -> None:
        stumbling.left = 0.7
        original(session, seconds, cancel_soak)

    monkeypatch.setattr(watch, "run_wall_time", run)
    wrong = wrong_program("period_for_frequency")
    judgement = judge_on_the_wall_clock(wrong)
    assert judgement.recording is not None
    assert judgement.recording.held_up_s >= 0.7
    assert "so busy" in judgement.inconclusive_reason
    assert Recording.from_json(judgement.recording.to_json()).held_up_s == judgement.recording.held_up_s


TO_THE_END = load_exercise("08_humanoid_status_publisher", ROOT)


def reason_about_end(
    cause: str = "exits-cleanly.exit-code", rate_lost: bool = False, **changes: Any
) -> InconclusiveReason:
    """Return the doubt about a program that lost the points for its end, and, on request, those for a rate."""
    recording = replace(stored("solution"), **changes)
    rate = CriterionResult("rate", "Its rate", "failed", 0.0, 2.0, False, "1 Hz", "2 Hz", "", "")
    ended = replace(rate, id="ends_cleanly", cause=cause, about_end=True)
    return find_inconclusive_reason(
        [*[rate] * rate_lost, ended], recording, TO_THE_END.plan, TO_THE_END.periods
    )


@pytest.mark.parametrize(
    ("process", "doubtful"),
    [
        ({"signal": "SIGSEGV"}, True),
        ({"signal": "SIGABRT"}, False),
        ({"signal": "SIGSEGV", "ended_by": "itself"}, False),
        ({"signal": "SIGSEGV", "limits_hit": ("output",)}, False),
    ],
)
def test_a_crash_in_the_middle_of_ctrl_c_leaves_a_doubt_about_the_end(
    process: dict[str, Any], doubtful: bool
) -> None:
    crashed = replace(stored("solution").process, exit=None, ended_by="judge")
    found = reason_about_end("exits-cleanly.crashed", process=replace(crashed, **process))
    assert ("crashed" in found.reason) is doubtful
    assert found.end_only is doubtful


def test_a_crash_at_ctrl_c_excuses_no_other_criterion() -> None:
    """What the program published before Ctrl-C stays conclusive, and the crash loses no points there."""
    crashed = replace(stored("eleven_values").process, exit=None, ended_by="judge", signal="SIGSEGV")
    assert inconclusive_reason(replace(stored("eleven_values"), process=crashed)) == ""
    assert reason_about_end("exits-cleanly.crashed", rate_lost=True, process=crashed).end_only


@pytest.mark.parametrize("cause", ["exits-cleanly.crashed", "exits-cleanly.overtaken"])
def test_a_busy_machine_disturbs_the_end_as_well(cause: str) -> None:
    found = reason_about_end(cause, clock="wall", watched_s=10.0, in_line_s=2.0)
    assert "so busy" in found.reason and not found.end_only


@pytest.mark.parametrize("cause", ["exits-cleanly.aborted", "exits-cleanly.overtaken"])
def test_an_end_that_python_or_rclpy_may_have_spoiled_leaves_a_doubt(cause: str) -> None:
    assert reason_about_end(cause).end_only
    assert reason_about_end() == InconclusiveReason()


def test_the_exercises_say_which_criteria_are_about_the_end() -> None:
    found = {
        stem: [one.id for one in load_exercise(stem, ROOT).criteria if one.about_end]
        for stem in stems(ROOT / "solutions")
    }
    assert {stem: ids for stem, ids in found.items() if ids} == {
        "01_the_context": ["arms_parked", "ends_cleanly", "node_gone"],
        "08_humanoid_status_publisher": ["ends_cleanly"],
    }
    assert {stem for stem in found if load_exercise(stem, ROOT).to_the_end} == {
        "01_the_context", "08_humanoid_status_publisher",
    }  # fmt: skip


CRASHES_AT_CTRL_C = """
import os, signal
import rclpy
from rclpy.node import Node

rclpy.init()
try:
    rclpy.spin(Node("humanoid_status_publisher"))
except KeyboardInterrupt:
    os.kill(os.getpid(), signal.SIGSEGV)
"""


def test_a_live_crash_at_ctrl_c_leaves_no_doubt_where_the_end_is_not_judged() -> None:
    judgement = judge_on_the_wall_clock(CRASHES_AT_CTRL_C)
    assert judgement.recording is not None and judgement.recording.process.signal == "SIGSEGV"
    assert "crashed" not in judgement.inconclusive_reason and not judgement.end_only


# Its first start hits rclpy's race: the context shuts down between the check and the shutdown. To keep the context up
# until then, Python handles Ctrl-C in that start, not rclpy.
OVERTAKEN_ONCE = """
import linecache, os, sys
from rclpy.signals import SignalHandlerOptions

def overtake(frame, event, argument):
    name = frame.f_code.co_filename
    if not name.endswith("rclpy/context.py"):
        return None
    if event == "line" and linecache.getline(name, frame.f_lineno).strip() == "self.__context.shutdown()":
        sys.settrace(None)
        frame.f_locals["self"].handle.shutdown()
    return overtake

HANDLED = SignalHandlerOptions.ALL
if not os.path.exists({marker!r}):
    HANDLED = SignalHandlerOptions.NO
    open({marker!r}, "w").close()
    sys.settrace(overtake)
"""


@pytest.mark.whole
def test_a_right_answer_whose_end_rclpy_has_spoiled_once_gets_full_marks(tmp_path: Path) -> None:
    exercise = load_exercise("01_the_context", ROOT)
    marker = tmp_path / "met"
    suppresses = (ROOT / "tests/right_answers/01_the_context/suppresses.py").read_text(encoding="utf-8")
    assert suppresses.count("    rclpy.init()\n") == 1
    changed = suppresses.replace("rclpy.init()", "rclpy.init(signal_handler_options=HANDLED)")
    first, _, rest = changed.partition("ROUND_S = 0.5\n")
    answer = Answer(f"{first}{OVERTAKEN_ONCE.format(marker=str(marker))}\nROUND_S = 0.5\n{rest}")
    provisional: list[Judgement] = []
    with Observer() as observer:
        judgement = until_sure(lambda: Judge(observer).judge(exercise, answer), provisional.append)
    # A busy machine may make another try inconclusive, too.
    [spoiled] = [one for one in provisional if "own Ctrl-C handler" in one.inconclusive_reason]
    assert END_OVERTAKEN in {one.cause for one in spoiled.criteria if one.status == "failed"}
    assert judgement.full_marks and not judgement.inconclusive_reason, as_text(judgement)


@pytest.mark.parametrize(
    ("process", "doubtful"),
    [
        ({"exit": 0, "signal": None}, True),
        ({"exit": 1, "signal": None}, True),
        ({"exit": None, "signal": "SIGKILL"}, False),
        ({"exit": 0, "signal": None, "ended_by": "itself"}, False),
    ],
)
def test_a_node_that_stays_after_an_end_in_order_leaves_a_doubt(
    process: dict[str, Any], doubtful: bool
) -> None:
    good = stored("solution")
    nodes = tuple(replace(node, stayed=True) for node in good.nodes)
    ended = replace(good.process, **({"ended_by": "judge"} | process))
    found = reason_about_end("nodes-gone-at-end.cut-off", nodes=nodes, process=ended)
    assert ("was not seen leaving the graph" in found.reason) is doubtful
    assert found.end_only is doubtful


def test_the_judge_keeps_off_the_domain_that_an_answer_names() -> None:
    """If the judge happened to be on that domain, it would accept a node on a wrong domain."""
    wrong = wrong_program("domain_argument")
    with Observer(lease_domain(30)) as observer:
        judgement = Judge(observer).judge(EXERCISE, Answer(wrong))
        assert observer.domain_id != 30
    first = next(result for result in judgement.criteria if result.status == "failed")
    assert first.id == "program_runs"
    assert "domain 30" in first.saw + first.because


def test_an_answer_that_names_every_domain_is_judged_like_any_other() -> None:
    right = EXERCISE.source.solution_code + f"# domains: {' '.join(map(str, range(1, 102)))}\n"
    with Observer() as observer:
        assert Judge(observer).judge(EXERCISE, Answer(right), soak=False).full_marks
