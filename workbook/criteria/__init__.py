"""How answers are judged: criteria, their points, and the vocabulary they are written in."""

from workbook.criteria.criterion import Criterion, Topic, criterion, topic, watching
from workbook.criteria.verdict import Verdict, all_of, failed, partial, passed
from workbook.criteria.words_of_programs import alive_at_end, exits_cleanly, program_runs
from workbook.criteria.words_of_rates import counts, keeps_period, rate, topic_pace
from workbook.criteria.words_of_topics import no_message, publishes
from workbook.criteria.words_of_values import (
    finite,
    length,
    never_rises,
    one_of,
    really_arrives,
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
    "keeps_period",
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
