"""Judge the whole program: whether it starts, and whether it keeps running until the judge stops watching."""

from dataclasses import dataclass

from workbook.criteria.criterion import criterion
from workbook.criteria.rules import Words, otherwise
from workbook.criteria.verdict import Verdict, passed
from workbook.criteria.vocabulary.driver import forged_report
from workbook.criteria.vocabulary.known_errors import (
    AN_ERROR_ENDED_IT,
    failed_by_error,
    failed_while_spinning,
    find_error,
)
from workbook.criteria.vocabulary.phrasing import nodes_are, seconds
from workbook.criteria.vocabulary.spins import held_by_a_spin, initialized_again
from workbook.criteria.vocabulary.stops import ended_by_signal, stopped_by_judge
from workbook.recording.recording import ProcessRecord, Recording

WORDS = Words(__file__)

AT_ONCE_S = 8.0
"""An error within this time (s) of the start may have occurred while the program was starting.

On a very busy machine, a program may take that long to start.
"""
A_ROUND_S = 0.95
"""If a program spun for at least this long (s), the judge has certainly seen its publishers.

If it spun for a shorter time, the judge may have missed them by chance.
"""
ANOTHER_MIDDLEWARE = "Expected RMW implementation identifier"
"""The message that rcl logs before it terminates a program with exit code 102."""


@dataclass(frozen=True)
class _Program:
    """A program, and its nodes and publishers in the graph."""

    recording: Recording

    @property
    def process(self) -> ProcessRecord:
        return self.recording.process

    @property
    def ended_at(self) -> float:
        return self.process.ended_at or 0.0

    @property
    def nodes(self) -> list[str]:
        return sorted(node.name for node in self.recording.nodes)

    @property
    def at_home(self) -> bool:
        """Whether the program uses the judge's ROS domain."""
        return self.recording.domain_id in self.process.domains_used

    @property
    def strangers(self) -> list[int]:
        """The other ROS domains that the program uses."""
        return [domain for domain in self.process.domains_used if domain != self.recording.domain_id]

    @property
    def had_publishers(self) -> bool:
        return any(topic.publishers for topic in self.recording.topics.values())


_BY_SIGNAL = WORDS.seen("program-runs.by-signal", _Program)
_NOT_SEEN = WORDS.seen("program-runs.not-seen", _Program)
_OTHER_DOMAIN = WORDS.cause("program-runs.other-domain", _Program)
_ENDED = WORDS.rules(
    _Program,
    "program-runs",
    ("other-middleware", lambda one: ANOTHER_MIDDLEWARE in one.process.log),
    ("ended", otherwise),
)
_NOT_THERE = WORDS.rules(
    _Program,
    "program-runs",
    ("discovery-changed", lambda one: one.at_home and not one.recording.nodes),
    ("node-destroyed", lambda one: one.had_publishers),
)
_PUBLISHES_NOTHING = WORDS.cause("program-runs.publishes-nothing", _Program)
_NO_NODE = WORDS.cause("program-runs.no-node", _Program)
_ENDED_BY_ERROR = WORDS.seen("alive-at-end.by-error", _Program)
_ENDED_BY_SIGNAL = WORDS.seen("alive-at-end.by-signal", _Program)
_ENDED_BY_ITSELF = WORDS.cause("alive-at-end.ended", _Program)


@criterion(points=0, title="Your program runs and its node is in the graph")
def program_runs(recording: Recording) -> Verdict:
    """Check that the program starts, and that its node or one of its publishers appears in the graph.

    This function is a complete criterion that's worth no points. To let other criteria depend on it, import it into the
    criteria file: `from workbook.criteria import program_runs`.
    """
    forged = forged_report(recording)
    if forged is not None:
        return forged
    one = _Program(recording)
    if _got_going(recording):
        nodes = sorted(set(one.nodes))
        return passed(f"{nodes_are(nodes) if nodes else 'publishers are'} in the graph")
    if one.strangers and not one.at_home:
        return _OTHER_DOMAIN.verdict(one)
    _, expected = _NOT_SEEN(one)
    if one.process.ended_by != "itself":
        stopped = stopped_by_judge(one.process, "the program", " and was stopped", expected)
        return stopped or _runs_unseen(one)
    blamed = failed_by_error(recording, "", expected)
    if blamed is not None:
        return blamed
    return (
        ended_by_signal(one.process, *_BY_SIGNAL(one))
        if one.process.signal is not None
        else _ENDED.verdict(one)
    )


def _runs_unseen(one: _Program) -> Verdict:
    """Return a failed verdict for a program that is still running without a lasting node or publisher in the graph."""
    early = initialized_again(one.recording, *_NOT_SEEN(one)) or _NOT_THERE.first(one)
    if early is not None:
        return early
    if not one.nodes:
        return _NO_NODE.verdict(one)
    nothing = _PUBLISHES_NOTHING.verdict(one)
    return held_by_a_spin(one.recording, nothing.saw, nothing.expected) or nothing


def _got_going(recording: Recording) -> bool:
    """Return whether a message arrived, or a publisher appeared and stayed while the program ran.

    A program that fails in its first lines may briefly have publishers and send one message per topic, but it doesn't
    count as running. A program that fails in a callback does count, even if its timer fired only once, because chance
    decides how many of its messages arrive.
    """
    topics = recording.topics.values()
    if _failed_at_once(recording):
        return False
    if any(topic.arrivals or topic.undecodable or topic.not_kept for topic in topics):
        return True
    if recording.published or recording.calls:
        return bool(recording.nodes)  # a program that only responds may have nothing to publish yet
    if recording.process.ended_by == "itself":
        return failed_while_spinning(recording.process.log) and any(topic.publishers for topic in topics)
    return any(publisher.last_seen is None for topic in topics for publisher in topic.publishers)


def _failed_at_once(recording: Recording) -> bool:
    """Return whether the program exited with an error right away.

    That means that it exited within `AT_ONCE_S`, no topic had a second message, and the program hadn't spun for
    `A_ROUND_S`.
    """
    process = recording.process
    if process.ended_by != "itself" or find_error(process.log, process.program) is None:
        return False
    if failed_while_spinning(process.log) and recording.watched_s >= A_ROUND_S:
        return False
    return (
        bool(recording.topics)
        and not recording.published
        and not recording.calls
        and all(len(topic.arrivals) <= 1 for topic in recording.topics.values())
        and (process.ended_at or 0.0) < AT_ONCE_S
    )


def ended_by_error(recording: Recording, saw: str, expected: str) -> Verdict | None:
    """Return a failed verdict that blames the error that made the program exit.

    The result is None if the program kept running or exited without an error.
    """
    if recording.process.ended_by != "itself":
        return None
    missing = saw.partition(AN_ERROR_ENDED_IT)[0]  # the verdict of `rate` may already quote the same error
    return failed_by_error(recording, f"{missing}{AN_ERROR_ENDED_IT}", expected)


def alive_at_end(recording: Recording) -> Verdict:
    """Check that the program is still running when the judge stops watching."""
    one = _Program(recording)
    process, told = one.process, _ENDED_BY_ERROR(one)
    begin = f"the program was stopped after {seconds(one.ended_at)}: it"
    stopped = stopped_by_judge(process, begin, "", told[1])
    if stopped is not None:
        return stopped
    if process.ended_by != "itself":
        if recording.clock == "simulated":
            return passed(f"still running after {seconds(recording.watched_s)} of robot time")
        return passed(f"still running after {seconds(process.watched_for)}")
    blamed = failed_by_error(recording, *told)
    if blamed is not None:
        return blamed
    return (
        ended_by_signal(process, *_ENDED_BY_SIGNAL(one))
        if process.signal is not None
        else _ENDED_BY_ITSELF.verdict(one)
    )
