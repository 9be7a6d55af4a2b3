"""Judge recordings by criteria. A *criterion* is one judged statement about a recording, worth some points.

The functions for writing criteria are called the *vocabulary*. A criteria file imports only this package, as `see`, and
message types, so it runs without rclpy. Feedback strings come from *catalogs* (see `rules`). Importing the package
raises CatalogError if a catalog of the vocabulary has an entry that no cause uses.
"""

import sys

from workbook.criteria.criterion import Criterion, Topic, criterion, topic, watching
from workbook.criteria.rules import Cause, Observation, Reason, Rules, Words, otherwise, refuse_leftovers
from workbook.criteria.verdict import Verdict, all_of, failed, not_judged, partial, passed
from workbook.criteria.vocabulary.arrays import length, varies
from workbook.criteria.vocabulary.batteries import begins_full, drains, word_fits_charge
from workbook.criteria.vocabulary.cameras import (
    CameraView,
    camera_image,
    seen_direction,
    seen_pixel,
    things_seen,
)
from workbook.criteria.vocabulary.driver import DriverCall, driver_calls, driver_reports, failed_in_call
from workbook.criteria.vocabulary.endings import exits_cleanly
from workbook.criteria.vocabulary.heartbeats import Beats, beats
from workbook.criteria.vocabulary.known_errors import failed_at_the_end, failed_by_error, last_error
from workbook.criteria.vocabulary.nodes import nodes_gone_at_end, on_the_graph
from workbook.criteria.vocabulary.numbers import finite, given_floats, never_rises, really_arrives, within
from workbook.criteria.vocabulary.pairing import latest_before, pair_in_order, published, script
from workbook.criteria.vocabulary.phrasing import count, listing, number
from workbook.criteria.vocabulary.processor import processor_share
from workbook.criteria.vocabulary.programs import alive_at_end, ended_by_error, program_runs
from workbook.criteria.vocabulary.qos import hears, kept_for_latecomers
from workbook.criteria.vocabulary.rates import counts, keeps_period, rate, topic_pace
from workbook.criteria.vocabulary.relays import Relay, Waits
from workbook.criteria.vocabulary.services import answered_calls, calls_of, calls_service, offers
from workbook.criteria.vocabulary.silences import ended_or_error, program_ended
from workbook.criteria.vocabulary.stamps import Stamp
from workbook.criteria.vocabulary.standstills import without_standstills
from workbook.criteria.vocabulary.subscriptions import asks_for_other_qos, listens
from workbook.criteria.vocabulary.texts import has_text, one_of
from workbook.criteria.vocabulary.topics import needs_messages, no_message, publishes
from workbook.criteria.vocabulary.type_checks import (
    Probe,
    findings,
    mypy_accepts,
    mypy_clean,
    mypy_objects,
    probe,
)
from workbook.criteria.vocabulary.values import elements, once, part_of, values
from workbook.recording.recording import Arrival, CallSeen, Published, Recording
from workbook.recording.script import BEFORE_START, calls, publish, serves
from workbook.recording.script import Part as Part  # a union: named in hints, but not in the vocabulary
from workbook.scenes.scene import Box, Cup, Plate, Scene, on_desk

__all__ = [
    "BEFORE_START", "Arrival", "Beats", "Box", "CallSeen", "CameraView", "Cause", "Criterion", "Cup", "DriverCall",
    "Observation", "Plate", "Probe", "Published", "Reason", "Recording", "Relay", "Rules", "Scene", "Stamp",
    "Topic", "Verdict", "Waits", "Words", "alive_at_end", "all_of", "answered_calls", "asks_for_other_qos", "beats",
    "begins_full", "calls", "calls_of", "calls_service", "camera_image", "count", "counts", "criterion", "drains",
    "driver_calls", "driver_reports", "elements", "ended_by_error", "ended_or_error", "exits_cleanly", "failed",
    "failed_at_the_end", "failed_by_error", "failed_in_call", "findings", "finite", "given_floats", "has_text",
    "hears", "keeps_period", "kept_for_latecomers", "last_error", "latest_before", "length", "listens", "listing",
    "mypy_accepts", "mypy_clean", "mypy_objects", "needs_messages", "never_rises", "no_message",
    "nodes_gone_at_end", "not_judged", "number", "offers", "on_desk", "on_the_graph", "once", "one_of", "otherwise",
    "pair_in_order", "part_of", "partial", "passed", "probe", "processor_share", "program_ended", "program_runs",
    "publish", "published", "publishes", "rate", "really_arrives", "script", "seen_direction", "seen_pixel",
    "serves", "things_seen", "topic", "topic_pace", "values", "varies", "watching", "within", "without_standstills",
    "word_fits_charge",
]  # fmt: skip

for _name in [name for name in sys.modules if name.startswith(f"{__name__}.vocabulary.")]:
    refuse_leftovers(sys.modules[_name])
