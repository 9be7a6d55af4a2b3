"""Whether a judgement is conclusive.

Where it is not, points may be lost without the answer's fault, or given for a script that was cut short, and the answer
is tried again (see `workbook.exercise.retries`).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from statistics import median

from workbook.criteria.runner import CriterionResult
from workbook.recording.plan import Plan
from workbook.recording.recording import Recording

HELD_UP_SHARE = 0.25
"""Share of the shortest judged period: half of the extra gap that fails a rate."""
LEAST_HELD_UP_S = 0.1
"""A shorter delay of the judge is usual on any machine and moves no verdict."""
RUN_QUEUE_SHARE = 0.1
"""Share of the watch that a program may spend in the run queue, ready but without a processor."""
RUN_QUEUE_SHARE_ABOUT_TIME = 0.05
"""The same where it was late. Measured: a right answer that polls spent 0.6 s of 6.5 s in the run queue, in small
pieces, and was typically 54 ms late."""
STEAL_SHARE = 0.15
"""Share of the watch that the host of a virtual machine steals from a processor, in pieces of whatever length."""
FEW_ODD_GAPS = 2
"""A message that comes late once makes one gap too long and the next too short."""
END_OVERTAKEN, END_ABORTED = "exits-cleanly.overtaken", "exits-cleanly.aborted"
EXCUSED_ENDS = frozenset({END_OVERTAKEN, END_ABORTED})
"""Causes of points that are lost to an end that rclpy or Python may have spoiled."""
FLOODS = frozenset({"rate.without-a-pause", "rate.grows"})
"""Causes that no machine brings about, however busy it is: it makes a program slower, and never so fast."""
BUSY_MACHINE = ".busy-machine"
"""End of the causes of points that a busy machine alone may cost: an exercise says so where milliseconds are judged."""
WITH_THE_NEXT = 1.25
"""Periods after which a message that was lost at first has come: with the next one, which may be late itself."""


@dataclass(frozen=True)
class InconclusiveReason:
    """Why a judgement may be unfair to the answer, as a sentence; empty when it is conclusive.

    `end_only`: only the points for the program's end are in doubt.
    """

    reason: str = ""
    end_only: bool = False


def find_inconclusive_reason(
    judged: Sequence[CriterionResult],
    recording: Recording,
    plan: Plan,
    periods: Mapping[str, float],
    on_simulated_time: Sequence[CriterionResult] = (),
) -> InconclusiveReason:
    """What makes the judgement inconclusive.

    A judgement that takes no points away is conclusive, unless the watch ended before the script did. How a program
    ends casts no doubt on what it did before.
    `periods`: of the topics that have a rate, in s.
    `on_simulated_time`: the results of the same program on simulated time before, where both speeds agreed.
    """
    lost = [
        result for result in judged if result.status in ("failed", "partial") and result.cause not in FLOODS
    ]
    if not lost:
        return InconclusiveReason(script_cut_short(recording))
    disturbed = (
        _node_never_discovered(recording)
        or _publisher_never_matched(recording, plan)
        or _clocks_contradict(lost, on_simulated_time)
        or _judge_was_delayed(lost, recording, plan)
        or _program_was_starved(lost, recording)
        or _busy_machine_to_blame(lost)
        or _one_message_was_late(lost, recording, periods)
    )
    if disturbed:
        return InconclusiveReason(disturbed)
    of_end = [result for result in lost if result.about_end]
    spoiled = _end_spoiled(of_end, recording) if of_end else ""
    return InconclusiveReason(spoiled, end_only=bool(spoiled))


def script_cut_short(recording: Recording) -> str:
    """Say what of the script was never sent, or return "" if nothing counts.

    A program is not praised for what it never met. One that ended by itself is judged by its end.
    """
    if recording.unpublished and _was_alive_throughout(recording):
        left = len(recording.unpublished)
        were = "1 message of the script was" if left == 1 else f"{left} messages of the script were"
        return f"the watch ended before {were} sent"
    return ""


def _end_spoiled(lost: Sequence[CriterionResult], recording: Recording) -> str:
    """Why the end may not be the program's own doing, as a sentence; empty if it is. `lost`: criteria about the end."""
    return (
        crashed_on_interrupt(recording)
        or _end_overtaken(lost)
        or _end_aborted(lost)
        or _node_seen_after_exit(recording)
    )


def _was_alive_throughout(recording: Recording) -> bool:
    return recording.process.ended_by != "itself" and not recording.process.limits_hit


def _node_never_discovered(recording: Recording) -> str:
    """A program with open DDS ports on our domain has a node; if we saw none, discovery has failed."""
    here = recording.domain_id in recording.process.domains_used
    if here and _was_alive_throughout(recording) and not recording.nodes and not recording.with_publishers():
        return f"the program was on domain {recording.domain_id}, and its node was never seen there"
    return ""


def _publisher_never_matched(recording: Recording, plan: Plan) -> str:
    if not _was_alive_throughout(recording):
        return ""
    for name in plan.topics:
        topic = recording.topic(name)
        there = any(publisher.last_seen is None for publisher in topic.publishers)
        if there and topic.window is None and not topic.arrivals:
            return f"the publisher of {name} was seen, and the judge was never connected to it"
    return ""


def crashed_on_interrupt(recording: Recording) -> str:
    """Why the points may be lost to a crash of rclpy itself at Ctrl-C, as a sentence; empty when there was none.

    rclpy's signal thread walks a list of guard conditions which its shutdown frees, and neither waits for the other. On
    a busy machine the thread may lose the processor in the middle, and then a correct program crashes with SIGSEGV.
    Source: https://github.com/ros2/rclpy/blob/jazzy/rclpy/src/rclpy/signal_handler.cpp (trigger_guard_conditions and
    unregister_sigint_guard_condition); measured with a thread that is held up there.
    """
    process = recording.process
    if process.ended_by == "judge" and process.signal == "SIGSEGV" and not process.limits_hit:
        return (
            "the program crashed while Ctrl-C ended it, which happens now and then because of a bug in rclpy"
        )
    return ""


def _end_overtaken(lost: Sequence[CriterionResult]) -> str:
    """What an overtaken end looks like is text that any program can print: see `shutdown_overtaken`."""
    if any(result.cause == END_OVERTAKEN for result in lost):
        return "it looks as if rclpy's own handling of Ctrl-C had overtaken the program's shutdown"
    return ""


def _end_aborted(lost: Sequence[CriterionResult]) -> str:
    """A thread that the program joins may still spin while Python goes down, which aborts the process now and then.

    Where Ctrl-C interrupts `Thread.join()`, Python up to 3.12 takes the thread for ended, and the next join returns at
    once. Source: `_wait_for_tstate_lock` in https://github.com/python/cpython/blob/3.11/Lib/threading.py.
    """
    if any(result.cause == END_ABORTED for result in lost):
        return "the program aborted at its end, which Python can cause where Ctrl-C interrupts Thread.join()"
    return ""


def _node_seen_after_exit(recording: Recording) -> str:
    """A participant announces once that it leaves, and nobody repeats what gets lost of it on a busy machine."""
    process = recording.process
    if process.ended_by == "judge" and process.exit is not None:
        for node in recording.nodes:
            if node.stayed:
                return f"the program ended by itself after Ctrl-C, and {node.name} was not seen to leave the graph"
    return ""


def _clocks_contradict(lost: Sequence[CriterionResult], on_simulated_time: Sequence[CriterionResult]) -> str:
    held = {result.id for result in on_simulated_time if result.status == "passed"}
    for result in lost:
        if result.about_time and result.id in held:
            return f"{result.title!r} passed on robot time but not on the wall clock"
    return ""


def _judge_was_delayed(lost: Sequence[CriterionResult], recording: Recording, plan: Plan) -> str:
    longest = max(LEAST_HELD_UP_S, HELD_UP_SHARE * plan.shortest_period)
    about_time = any(result.about_time for result in lost)
    if recording.clock != "wall" or not about_time:
        return ""
    if recording.held_up_s >= longest:
        return f"this machine was so busy that the judge itself had to wait for {recording.held_up_s:.2f} s"
    if recording.stood_still_s >= longest:
        return (
            "this is a virtual machine, and its host gave one of its processors to others for "
            f"{recording.stood_still_s:.2f} s"
        )
    if 0.0 < STEAL_SHARE * recording.simulated_s <= recording.taken_s:
        return (
            "this is a virtual machine, and its host gave its processors to others for "
            f"{recording.taken_s:.1f} s of {recording.simulated_s:.0f} s"
        )
    return ""


def _program_was_starved(lost: Sequence[CriterionResult], recording: Recording) -> str:
    """On the wall clock a program that waits in the run queue is late with everything, whatever is judged.

    One that an error has ended was not late: the error is what it lost its points for.
    """
    if recording.process.ended_by == "itself" and recording.process.exit:
        return ""
    about_time = any(result.about_time for result in lost)
    share = RUN_QUEUE_SHARE_ABOUT_TIME if about_time else RUN_QUEUE_SHARE
    if recording.clock == "wall" and 0.0 < share * recording.simulated_s <= recording.in_line_s:
        return (
            f"this machine was so busy that the program waited for a processor for {recording.in_line_s:.1f} s "
            f"of {recording.simulated_s:.0f} s"
        )
    return ""


def _busy_machine_to_blame(lost: Sequence[CriterionResult]) -> str:
    """A criterion has found that a program without a fault may have been as late on this machine."""
    if any((result.cause or "").endswith(BUSY_MACHINE) for result in lost):
        return "this machine was so busy that a program without a fault may be late by some milliseconds"
    return ""


def _kept_waiting_s(recording: Recording) -> float:
    """For how long (s) the machine can have kept judge and program waiting, by all that was measured."""
    return recording.held_up_s + recording.stood_still_s + recording.taken_s + recording.in_line_s


def _one_message_was_late(
    lost: Sequence[CriterionResult], recording: Recording, periods: Mapping[str, float]
) -> str:
    """A publisher in step that is late once: it, or the message on its way, may have waited for the machine.

    A message that DDS has lost comes with the next one. Who pauses for longer, and was not kept waiting for so long,
    has paused. Where no rate is asked for, nobody can tell what is late.
    """
    if recording.clock != "wall" or not any(result.about_time for result in lost):
        return ""
    for name in periods:
        gaps = [after.t - before.t for before, after in pairwise(recording.topic(name).arrivals)]
        if len(gaps) < 2 * FEW_ODD_GAPS:
            continue
        usual = median(gaps)
        odd = [gap for gap in gaps if abs(gap - usual) > HELD_UP_SHARE * usual]
        late_s = max(odd, default=0.0) - usual
        longest = max(WITH_THE_NEXT * usual, _kept_waiting_s(recording))
        if len(odd) <= FEW_ODD_GAPS and 0.0 < late_s <= longest:
            return f"a message of {name} came {late_s:.2f} s late, and the others were in step"
    return ""
