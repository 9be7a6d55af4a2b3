"""How answers are judged: criteria, their points, and the vocabulary they are written in."""

from workbook.criteria.criterion import Criterion, Topic, criterion, topic, watching
from workbook.criteria.verdict import Verdict, all_of, failed, partial, passed
from workbook.criteria.words_of_nodes import nodes_gone_at_end, on_the_graph
from workbook.criteria.words_of_programs import alive_at_end, exits_cleanly, program_runs
from workbook.criteria.words_of_qos import hears, kept_for_latecomers
from workbook.criteria.words_of_rates import counts, keeps_period, rate, topic_pace
from workbook.criteria.words_of_services import calls_service
from workbook.criteria.words_of_talk import (
    answered_calls,
    calls_of,
    latencies,
    listens,
    offers,
    processor_share,
    said,
)
from workbook.criteria.words_of_topics import no_message, publishes
from workbook.criteria.words_of_types import Probe, findings, mypy_accepts, mypy_clean, mypy_objects, probe
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
from workbook.observing.recording import CallSeen, Recording
from workbook.observing.script import BEFORE_START, calls, says, serves

__all__ = [
    "BEFORE_START",
    "CallSeen",
    "Criterion",
    "Probe",
    "Recording",
    "Topic",
    "Verdict",
    "alive_at_end",
    "all_of",
    "answered_calls",
    "calls",
    "calls_of",
    "calls_service",
    "counts",
    "criterion",
    "exits_cleanly",
    "failed",
    "findings",
    "finite",
    "hears",
    "keeps_period",
    "kept_for_latecomers",
    "latencies",
    "length",
    "listens",
    "mypy_accepts",
    "mypy_clean",
    "mypy_objects",
    "never_rises",
    "no_message",
    "nodes_gone_at_end",
    "offers",
    "on_the_graph",
    "one_of",
    "partial",
    "passed",
    "probe",
    "processor_share",
    "program_runs",
    "publishes",
    "rate",
    "really_arrives",
    "said",
    "says",
    "serves",
    "topic",
    "topic_pace",
    "values",
    "varies",
    "watching",
    "within",
]
