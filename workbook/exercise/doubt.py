"""Whether a judgement that takes points away stands on firm ground.

Where it does not, the judgement is inconclusive: the answer deserves a second try.
"""

from collections.abc import Mapping, Sequence
from itertools import pairwise
from statistics import median

from workbook.criteria.runner import CriterionResult
from workbook.observing.recording import Recording
from workbook.observing.watch import Plan

HELD_UP_SHARE = 0.25
"""Share of the shortest judged period. A gap of half a period more is what fails a rate."""
LEAST_HELD_UP_S = 0.1
IN_LINE_SHARE = 0.1
"""Share of the watch for which a program may be ready to run without a processor."""
IN_LINE_SHARE_ABOUT_TIME = 0.05
"""The same where it was late: a right answer of exercise 11 stood in line for 0.6 s of 6.5 s, in small pieces, and was
typically 54 ms late."""
TAKEN_SHARE = 0.15
"""Share of the watch for which the host of a virtual machine keeps a processor, in pieces of whatever length."""
FEW = 2
"""A message that comes late once makes one gap too long and the next too short."""


def doubt_about(
    judged: Sequence[CriterionResult],
    recording: Recording,
    plan: Plan,
    periods: Mapping[str, float],
    on_robot_time: Sequence[CriterionResult] = (),
) -> str:
    """Why the judgement may do the answer wrong, as a sentence; empty when it is sound, or takes nothing away.

    `periods`: of the topics that have a rate, in s. `on_robot_time`: what held and what did not when the same program
    was judged on robot time before, where both speeds agreed.
    """
    lost = [result for result in judged if result.status in ("failed", "partial")]
    if not lost:
        return ""
    return (
        _never_seen(recording)
        or _never_matched(recording, plan)
        or crashed_at_its_end(recording)
        or _node_stayed(recording)
        or _clocks_contradict(lost, on_robot_time)
        or _held_up(lost, recording, plan)
        or _starved(lost, recording)
        or _late_once(lost, recording, periods)
    )


def _lived(recording: Recording) -> bool:
    return recording.process.ended_by != "itself" and not recording.process.limits_hit


def _never_seen(recording: Recording) -> str:
    """A program with open DDS ports on our domain has a node; if we saw none, discovery has failed."""
    here = recording.domain_id in recording.process.domains_used
    if here and _lived(recording) and not recording.nodes and not recording.published():
        return f"the program was on domain {recording.domain_id}, and its node was never seen there"
    return ""


def _never_matched(recording: Recording, plan: Plan) -> str:
    if not _lived(recording):
        return ""
    for name in plan.topics:
        topic = recording.topic(name)
        there = any(publisher.last_seen is None for publisher in topic.publishers)
        if there and topic.window is None and not topic.arrivals:
            return f"the publisher of {name} was seen, and the judge was never connected to it"
    return ""


def crashed_at_its_end(recording: Recording) -> str:
    """rclpy's signal thread walks a list of guard conditions which its shutdown frees, and neither waits for the other.

    On a busy machine the thread may lose the processor in the middle, and any program in order crashes at Ctrl-C.
    Source: https://github.com/ros2/rclpy/blob/jazzy/rclpy/src/rclpy/signal_handler.cpp (trigger_guard_conditions and
    unregister_sigint_guard_condition); measured with a thread that is held up there.
    """
    process = recording.process
    if process.ended_by == "bench" and process.signal == "SIGSEGV" and not process.limits_hit:
        return (
            "the program crashed while Ctrl-C ended it, which happens now and then by a fault of rclpy's own"
        )
    return ""


def _node_stayed(recording: Recording) -> str:
    """A participant says good-bye once, and nobody repeats what gets lost of it on a busy machine."""
    process = recording.process
    if process.ended_by == "bench" and process.exit is not None:
        for node in recording.nodes:
            if node.stayed:
                return f"the program ended by itself after Ctrl-C, and {node.name} was not seen to go"
    return ""


def _clocks_contradict(lost: Sequence[CriterionResult], on_robot_time: Sequence[CriterionResult]) -> str:
    held = {result.id for result in on_robot_time if result.status == "passed"}
    for result in lost:
        if result.about_time and result.id in held:
            return f"{result.title!r} held on robot time and not on the wall clock"
    return ""


def _held_up(lost: Sequence[CriterionResult], recording: Recording, plan: Plan) -> str:
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
    if 0.0 < TAKEN_SHARE * recording.robot_s <= recording.taken_s:
        return (
            "this is a virtual machine, and its host gave its processors to others for "
            f"{recording.taken_s:.1f} s of {recording.robot_s:.0f} s"
        )
    return ""


def _starved(lost: Sequence[CriterionResult], recording: Recording) -> str:
    """On the wall clock a program that stands in line for a processor is late with everything, whatever is judged."""
    about_time = any(result.about_time for result in lost)
    share = IN_LINE_SHARE_ABOUT_TIME if about_time else IN_LINE_SHARE
    if recording.clock == "wall" and 0.0 < share * recording.robot_s <= recording.in_line_s:
        return (
            f"this machine was so busy that the program stood in line for {recording.in_line_s:.1f} s "
            f"of {recording.robot_s:.0f} s"
        )
    return ""


def _late_once(lost: Sequence[CriterionResult], recording: Recording, periods: Mapping[str, float]) -> str:
    """A publisher in step that is late once: it, or the message on its way, may have waited for the machine.

    Where no rate is asked for, nobody can tell what is late.
    """
    if recording.clock != "wall" or not any(result.about_time for result in lost):
        return ""
    for name in periods:
        gaps = [after.t - before.t for before, after in pairwise(recording.topic(name).arrivals)]
        if len(gaps) < 2 * FEW:
            continue
        usual = median(gaps)
        odd = [gap for gap in gaps if abs(gap - usual) > HELD_UP_SHARE * usual]
        late_s = max(odd, default=0.0) - usual
        if len(odd) <= FEW and late_s > 0.0:
            return f"a message of {name} came {late_s:.2f} s late, and the others were in step"
    return ""
