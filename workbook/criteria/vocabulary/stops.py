"""Explain why a program was terminated from outside, because of one of the judge's limits or by a signal."""

from typing import Any

from workbook.criteria.rules import Words
from workbook.criteria.verdict import Verdict
from workbook.recording.limits import ANSWER_LIMITS, MB
from workbook.recording.recording import ProcessRecord

WORDS = Words(__file__)

_LIMITS: dict[str, Any] = {
    "limits": ANSWER_LIMITS,
    "output_mb": ANSWER_LIMITS.output // MB,
    "memory_gb": (ANSWER_LIMITS.memory or 0) / 1000 / MB,
    "queued_mb": (ANSWER_LIMITS.queued or 0) // MB,
    "stored_mb": (ANSWER_LIMITS.stored or 0) // MB,
    "kernel_mb": (ANSWER_LIMITS.kernel or 0) // MB,
    "files": f"{ANSWER_LIMITS.files:,}",
}
_STOPS = {
    limit: WORDS.cause(f"stopped.{limit}", ("begin", "end", "expected", *_LIMITS))
    for limit in ("output", "processes", "memory", "sockets", "descriptors", "files", "disk")
}
_SIGNALS = {
    name: WORDS.cause(f"signal.{reason}", ("saw", "expected", "limits"))
    for reason, names in (
        ("processor-time", ["SIGXCPU"]),
        ("killed", ["SIGKILL"]),
        ("crashed", ["SIGSEGV", "SIGABRT", "SIGBUS", "SIGFPE", "SIGILL"]),
        ("other", ["other"]),
    )
    for name in names
}


def stopped_by_judge(process: ProcessRecord, begin: str, end: str, expected: str) -> Verdict | None:
    """Return a failed verdict that names the limit for which the judge stopped the program, or None if it didn't.

    `begin` and `end`: the strings before and after a phrase such as "printed more than 50 MB".
    """
    hit = [limit for limit in process.limits_hit if limit in _STOPS] if process.ended_by == "judge" else []
    return _STOPS[hit[0]].verdict(begin=begin, end=end, expected=expected, **_LIMITS) if hit else None


def ended_by_signal(process: ProcessRecord, saw: str, expected: str) -> Verdict:
    """Return a failed verdict that blames the signal that terminated the program."""
    cause = _SIGNALS.get(process.signal or "", _SIGNALS["other"])
    return cause.verdict(saw=saw, expected=expected, limits=ANSWER_LIMITS)
