"""How answers are judged: criteria, their points, and the vocabulary they are written in."""

from workbook.criteria.criterion import Criterion, Topic, criterion, topic, watching
from workbook.criteria.verdict import Verdict, all_of, failed, partial, passed
from workbook.criteria.vocabulary import (
    alive_at_end,
    counts,
    exits_cleanly,
    finite,
    length,
    never_rises,
    no_message,
    one_of,
    program_runs,
    publishes,
    rate,
    really_arrives,
    topic_pace,
    values,
    varies,
    within,
)
from workbook.observing.recording import Recording

__all__ = [
    "Criterion",
    "Recording",
    "Topic",
    "Verdict",
    "alive_at_end",
    "all_of",
    "counts",
    "criterion",
    "exits_cleanly",
    "failed",
    "finite",
    "length",
    "never_rises",
    "no_message",
    "one_of",
    "partial",
    "passed",
    "program_runs",
    "publishes",
    "rate",
    "really_arrives",
    "topic",
    "topic_pace",
    "values",
    "varies",
    "watching",
    "within",
]
