"""Explain a silence by a fault in the program's source: a wrong spin or wait, or rclpy.init() in a loop."""

from workbook.criteria.rules import Words
from workbook.criteria.verdict import Verdict
from workbook.recording.recording import Recording, SpinSeen

WORDS = Words(__file__)

_AGAIN = WORDS.cause("spin.initialized-again", ("saw", "expected", "line"), about_time=True)
_DISTURBING = {
    how: WORDS.cause(f"spin.{reason}", ("saw", "expected", "spin"), about_time=True)
    for how, reason in (
        (("", True), "in-a-callback"),
        (("rate", True), "rate-in-a-callback"),
        (("rate", False), "rate-without-a-spin"),
        (("future", True), "await-in-a-callback"),
        (("future", False), "await-in-a-callback"),
    )
}
"""Keyed by `SpinSeen.waits`, and by whether the line is in a callback."""
_KEEPING = {
    kept: WORDS.cause(f"spin.{reason}", ("saw", "expected", "spin"), about_time=True)
    for kept, reason in (
        ("create", "before-the-rest"),
        ("spin", "second-never-reached"),
        ("round", "first-round-only"),
    )
}
"""Keyed by `SpinSeen.kept`, the step that the spin keeps from running."""


def disturbs_itself(recording: Recording, saw: str, expected: str) -> Verdict | None:
    """Return a failed verdict that blames a spin or wait in a callback, a wait in vain, or rclpy.init() in a loop.

    The result is None if the source has none of these faults, or if the program exited by itself. Source code alone
    doesn't prove anything, so call this function only if the recording shows a fault, which `saw` describes.
    """
    found = (
        _DISTURBING[spin.waits, bool(spin.callback)].verdict(saw=saw, expected=expected, spin=spin)
        for spin in _spins(recording)
        if spin.callback or spin.waits
    )
    return initialized_again(recording, saw, expected) or next(found, None)


def initialized_again(recording: Recording, saw: str, expected: str) -> Verdict | None:
    """Return a failed verdict that blames an rclpy.init() call in a loop.

    The result is None if the source has no such loop, or if the program exited by itself.
    """
    if recording.process.ended_by == "itself" or not recording.repeated_init:
        return None
    return _AGAIN.verdict(saw=saw, expected=expected, line=recording.repeated_init)


def held_by_a_spin(
    recording: Recording, saw: str, expected: str, *, of_a_spun_node: bool = False
) -> Verdict | None:
    """Return a failed verdict that blames a spin for something that is missing, such as a publisher.

    The spin doesn't return, so the lines after it never run. The faults of `disturbs_itself` are checked first. The
    result is None if the source has no such fault, or if the program exited by itself.

    `of_a_spun_node`: whether the node's other callbacks run. If so, an unspun node can't be the cause.
    """
    kinds = ("create",) if of_a_spun_node else tuple(_KEEPING)
    found = (
        _KEEPING[spin.kept].verdict(saw=saw, expected=expected, spin=spin)
        for spin in _spins(recording)
        if spin.kept in kinds
    )
    return disturbs_itself(recording, saw, expected) or next(found, None)


def _spins(recording: Recording) -> tuple[SpinSeen, ...]:
    return () if recording.process.ended_by == "itself" else tuple(recording.spins)
