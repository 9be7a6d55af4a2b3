"""Explains silence by the source: spins and waits in callbacks, a spin that never returns, rclpy.init() in a loop."""

from workbook.criteria.verdict import Verdict, failed
from workbook.recording.recording import Recording, SpinSeen

ONE_EXECUTOR = (
    "Create everything first. Then spin once, as the last step: rclpy.spin(node), or one executor to which you have "
    "added all nodes."
)


def disturbs_itself(recording: Recording, saw: str, expected: str) -> Verdict | None:
    """A failed verdict that blames a spin in a callback, a rate that never wakes, or ROS initialized again and again.

    None if the source has none of them, or the program has ended.

    The source alone is no verdict: this is only for a program from which something is missing. `saw` says what.
    """
    spins = () if recording.process.ended_by == "itself" else recording.spins
    return initialized_again(recording, saw, expected) or next(
        (_HOW[one.waits](one, saw, expected) for one in spins if one.callback or one.waits),
        None,
    )


def initialized_again(recording: Recording, saw: str, expected: str) -> Verdict | None:
    """A failed verdict that blames an rclpy.init() in a loop; None if there is none, or the program has ended."""
    if recording.process.ended_by == "itself" or not recording.repeated_init:
        return None
    return failed(
        "spin.initialized-again",
        f"{saw}; line {recording.repeated_init} initializes ROS again and again, in a loop",
        expected,
        "Each iteration creates a new node and shuts it down again. Discovery takes a moment, and by then the node "
        "is gone, so nothing receives its messages.",
        "Call rclpy.init() once, create one node, and let its timers publish while rclpy.spin(node) runs.",
        about_time=True,
    )


def held_by_a_spin(
    recording: Recording, saw: str, expected: str, *, of_a_spun_node: bool = False
) -> Verdict | None:
    """The same for something that never was, also where a spin does not return and keeps later lines from running.

    `of_a_spun_node`: other callbacks of its node are called, so it is not a node that nothing spins.
    """
    spins = () if recording.process.ended_by == "itself" else recording.spins
    kinds = ("create",) if of_a_spun_node else ("create", "spin", "round")
    return disturbs_itself(recording, saw, expected) or next(
        (_keeps(one, saw, expected) for one in spins if one.kept in kinds), None
    )


def _in_callback(spin: SpinSeen, saw: str, expected: str) -> Verdict:
    return failed(
        "spin.in-a-callback",
        f"{saw}; line {spin.line} spins in a callback ({spin.callback}): {spin.code}",
        expected,
        "An executor is already running this callback. A second spin in it takes the node away from that executor, or "
        "calls other callbacks in the middle of this one.",
        f"Remove the spin from line {spin.line}, and let the callback return. The executor then calls the others.",
        about_time=True,
    )


def _waits_for_rate(spin: SpinSeen, saw: str, expected: str) -> Verdict:
    if spin.callback:
        return failed(
            "spin.rate-in-a-callback",
            f"{saw}; line {spin.line} waits for a rate in a callback ({spin.callback}): {spin.code}",
            expected,
            "A rate wakes up when its timer fires. The executor would have to serve this timer, but it is still "
            "running this callback. So both wait forever.",
            f"Remove line {spin.line}, and let create_timer(period, callback) call the callback again.",
            about_time=True,
        )
    return failed(
        "spin.rate-without-a-spin",
        f"{saw}; line {spin.line} waits for a rate, and nothing spins in that time: {spin.code}",
        expected,
        "A rate wakes up when its timer fires, and timers fire only while a thread spins the node. The only thread is "
        "asleep in this line.",
        "Put what the loop does into a callback: create_timer(period, callback). Then call rclpy.spin(node).",
        about_time=True,
    )


def _waits_for_future(spin: SpinSeen, saw: str, expected: str) -> Verdict:
    return failed(
        "spin.await-in-a-callback",
        f"{saw}; line {spin.line} waits in a callback ({spin.callback}): {spin.code}",
        expected,
        "An async callback occupies its callback group until it ends. All callbacks of this node are in one group, so "
        "none is called meanwhile. If one of them has to end the wait, it never ends.",
        "Remove the await, and let a timer call what comes later. Or give the callback a callback group of its own.",
        about_time=True,
    )


_HOW = {"": _in_callback, "rate": _waits_for_rate, "future": _waits_for_future}


def _keeps(spin: SpinSeen, saw: str, expected: str) -> Verdict:
    stays = f"{saw}; line {spin.line} does not return while the program runs: {spin.code}"
    if spin.kept == "round":
        return failed(
            "spin.first-round-only",
            f"{stays}; so the loop of line {spin.later} never begins its next iteration",
            expected,
            "A spin returns only when ROS is shut down. So the loop spins only its first node.",
            ONE_EXECUTOR,
            about_time=True,
        )
    if spin.kept == "spin":
        return failed(
            "spin.second-never-reached",
            f"{stays}; so line {spin.later} is never reached: {spin.later_code}",
            expected,
            "A spin returns only when ROS is shut down. So a spin on a later line never begins, and its node is "
            "never spun.",
            ONE_EXECUTOR,
            about_time=True,
        )
    return failed(
        "spin.before-the-rest",
        f"{stays}; so line {spin.later} is never reached: {spin.later_code}",
        expected,
        "A spin returns only when ROS is shut down. So nothing that a later line should create ever exists.",
        ONE_EXECUTOR,
        about_time=True,
    )
