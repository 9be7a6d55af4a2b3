"""Decide whether a judgment is conclusive.

In an inconclusive judgment, the answer may have lost points without being at fault, or earned points although the judge
didn't send its whole script. So the answer is judged again (see `workbook.exercise.retries`).

Most functions return a suspicion as a clause for feedback, or "" if there is no reason for it.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from statistics import median

from workbook.criteria.runner import CriterionResult
from workbook.recording.plan import Plan
from workbook.recording.recording import Recording

HELD_UP_SHARE = 0.25
"""The longest harmless delay, as a fraction of a period: half of the extra gap that makes a rate fail."""
LEAST_HELD_UP_S = 0.1
"""Shorter delays (s) of the judge are usual on any machine and don't change a verdict."""
RUN_QUEUE_SHARE = 0.1
"""The fraction of the watch that a program may spend in the run queue, ready but without a processor."""
RUN_QUEUE_SHARE_ABOUT_TIME = 0.05
"""The same limit for programs that were late.

Measured: a correct answer that polls spent 0.6 s of 6.5 s in the run queue, in small pieces, and was typically 54 ms
late.
"""
STEAL_SHARE = 0.15
"""The fraction of the watch for which a virtual machine's host may take a processor away, in pieces of any length."""
FEW_ODD_GAPS = 2
"""A single late message makes one gap too long and the next one too short."""
END_OVERTAKEN, END_ABORTED = "exits-cleanly.overtaken", "exits-cleanly.aborted"
EXCUSED_ENDS = frozenset({END_OVERTAKEN, END_ABORTED})
"""Causes of points lost for the program's exit, which a bug in rclpy or Python may have spoiled."""
FLOODS = frozenset({"rate.without-a-pause", "rate.grows"})
"""Causes that even a busy machine can't produce, because it makes a program slower, never faster."""
BUSY_MACHINE = ".busy-machine"
"""The suffix of causes that a busy machine alone may produce, for exercises that judge milliseconds."""
WITH_THE_NEXT = 1.25
"""The number of periods within which a lost message arrives.

DDS delivers it along with the next message, which may also be late.
"""


@dataclass(frozen=True)
class InconclusiveReason:
    """The reason why a judgment may be unfair to the answer, as a clause, or "" for a conclusive judgment.

    `end_only`: whether only the points for the program's exit are inconclusive.
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
    """Return the reason why the judgment is inconclusive.

    A judgment without lost points is conclusive, unless the watch ended before the script did. The way in which a
    program exits doesn't make its earlier behavior inconclusive. `periods`: the period (s) of each topic that has a
    rate. `on_simulated_time`: the same program's earlier results in simulated time, if both speeds agreed.
    """
    lost = [
        result for result in judged if result.status in ("failed", "partial") and result.cause not in FLOODS
    ]
    if not lost:
        return InconclusiveReason(script_cut_short(recording))
    reason = (
        _node_never_discovered(recording)
        or _publisher_never_matched(recording, plan)
        or _clocks_contradict(lost, on_simulated_time)
        or _judge_was_delayed(lost, recording, plan)
        or _program_was_starved(lost, recording)
        or _busy_machine_to_blame(lost)
        or _one_message_was_late(lost, recording, periods)
    )
    if reason:
        return InconclusiveReason(reason)
    of_end = [result for result in lost if result.about_end]
    spoiled = _end_spoiled(of_end, recording) if of_end else ""
    return InconclusiveReason(spoiled, end_only=bool(spoiled))


def script_cut_short(recording: Recording) -> str:
    """Describe the part of the script that was never sent, or return "" if the missing part doesn't matter.

    A program doesn't get credit for input that it never received. But a program that exited by itself is judged by its
    exit.
    """
    if recording.unpublished and _was_alive_throughout(recording):
        left = len(recording.unpublished)
        were = "1 message of the script was" if left == 1 else f"{left} messages of the script were"
        return f"the watch ended before {were} sent"
    return ""


def _end_spoiled(lost: Sequence[CriterionResult], recording: Recording) -> str:
    """Return why something other than the program may have spoiled its exit, or "" if nothing did.

    `lost`: the failed criteria about the exit.
    """
    return (
        crashed_on_interrupt(recording)
        or _end_overtaken(lost)
        or _end_aborted(lost)
        or _node_seen_after_exit(recording)
    )


def _was_alive_throughout(recording: Recording) -> bool:
    return recording.process.ended_by != "itself" and not recording.process.limits_hit


def _node_never_discovered(recording: Recording) -> str:
    """Suspect failed discovery if the program had DDS ports open on our domain, but we never saw its node there."""
    here = recording.domain_id in recording.process.domains_used
    if here and _was_alive_throughout(recording) and not recording.nodes and not recording.with_publishers():
        return f"the program was on domain {recording.domain_id}, but its node was never seen there"
    return ""


def _publisher_never_matched(recording: Recording, plan: Plan) -> str:
    if not _was_alive_throughout(recording):
        return ""
    for name in plan.topics:
        topic = recording.topic(name)
        there = any(publisher.last_seen is None for publisher in topic.publishers)
        if there and topic.window is None and not topic.arrivals:
            return f"the publisher of {name} was seen, but the judge never connected to it"
    return ""


def crashed_on_interrupt(recording: Recording) -> str:
    """Return why rclpy's own crash on Ctrl-C may have cost points, or "" if there was no such crash.

    rclpy's signal thread walks a list of guard conditions while rclpy's shutdown frees them, because neither waits for
    the other. If the thread loses the processor partway, as it may on a busy machine, even a correct program crashes
    with SIGSEGV. Source: https://github.com/ros2/rclpy/blob/jazzy/rclpy/src/rclpy/signal_handler.cpp
    (trigger_guard_conditions and unregister_sigint_guard_condition); measured by holding up the thread at that point.
    """
    process = recording.process
    if process.ended_by == "judge" and process.signal == "SIGSEGV" and not process.limits_hit:
        return "the program crashed while Ctrl-C ended it, which sometimes happens because of a bug in rclpy"
    return ""


def _end_overtaken(lost: Sequence[CriterionResult]) -> str:
    """Return why rclpy may have shut down before the program did so itself.

    Any program can print the error message by which we recognize this: see `shutdown_overtaken`.
    """
    if any(result.cause == END_OVERTAKEN for result in lost):
        return "it looks as if rclpy's own Ctrl-C handler shut the context down before the program did"
    return ""


def _end_aborted(lost: Sequence[CriterionResult]) -> str:
    """Return why the process may have aborted with a thread still spinning while Python was shutting down.

    If Ctrl-C interrupts `Thread.join()`, Python up to 3.12 assumes that the thread has finished. The next `join` then
    returns right away, although the thread is still spinning. Source: `_wait_for_tstate_lock` in
    https://github.com/python/cpython/blob/3.11/Lib/threading.py.
    """
    if any(result.cause == END_ABORTED for result in lost):
        return "the program aborted at its end, which can happen in Python if Ctrl-C interrupts Thread.join()"
    return ""


def _node_seen_after_exit(recording: Recording) -> str:
    """Return why a node may seem to outlive its program, or "" if none does.

    A participant announces its departure only once. If that message is lost on a busy machine, DDS doesn't resend it,
    so the node stays in our graph.
    """
    process = recording.process
    if process.ended_by == "judge" and process.exit is not None:
        for node in recording.nodes:
            if node.stayed:
                return f"the program ended by itself after Ctrl-C, but {node.name} was not seen leaving the graph"
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
    if 0.0 < STEAL_SHARE * recording.watched_s <= recording.taken_s:
        return (
            "this is a virtual machine, and its host gave its processors to others for "
            f"{recording.taken_s:.1f} s of {recording.watched_s:.0f} s"
        )
    return ""


def _program_was_starved(lost: Sequence[CriterionResult], recording: Recording) -> str:
    """Return why a lack of CPU time may have cost points: while a program waits in the run queue, it falls behind.

    This doesn't apply to a program that exited with an error, because then the error cost the points.
    """
    if recording.process.ended_by == "itself" and recording.process.exit:
        return ""
    about_time = any(result.about_time for result in lost)
    share = RUN_QUEUE_SHARE_ABOUT_TIME if about_time else RUN_QUEUE_SHARE
    if recording.clock == "wall" and 0.0 < share * recording.watched_s <= recording.in_line_s:
        return (
            f"this machine was so busy that the program waited for a processor for {recording.in_line_s:.1f} s "
            f"of {recording.watched_s:.0f} s"
        )
    return ""


def _busy_machine_to_blame(lost: Sequence[CriterionResult]) -> str:
    """Return why the machine may be to blame, if a criterion found a delay that even a correct program may have."""
    if any((result.cause or "").endswith(BUSY_MACHINE) for result in lost):
        return "this machine was so busy that even a correct program may be late by a few milliseconds"
    return ""


def _kept_waiting_s(recording: Recording) -> float:
    """Return the longest time, in seconds, that the machine may have delayed judge and program: all delays together."""
    return recording.held_up_s + recording.stood_still_s + recording.taken_s + recording.in_line_s


def _one_message_was_late(
    lost: Sequence[CriterionResult], recording: Recording, periods: Mapping[str, float]
) -> str:
    """Return why one late message may be the machine's fault, because its publisher or the message itself had to wait.

    A lost message arrives together with the next one. A pause that's longer than that and longer than the machine's
    delays is the program's own. Without a required rate, no message counts as late.
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
            return f"a message on {name} was {late_s:.2f} s late, but the others were on time"
    return ""
