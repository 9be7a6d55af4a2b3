"""Judge whether a program publishes on a topic with the right name and type, and whether messages arrive."""

import difflib
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property, wraps
from typing import Concatenate, ParamSpec

from workbook.criteria.criterion import CriterionFunction, Topic
from workbook.criteria.rules import Words, otherwise
from workbook.criteria.verdict import Verdict, passed
from workbook.criteria.vocabulary.known_errors import failed_by_error
from workbook.criteria.vocabulary.phrasing import count, seconds
from workbook.criteria.vocabulary.silences import goes_on, other_topics, program_ended, waits_for_clock
from workbook.criteria.vocabulary.spins import held_by_a_spin
from workbook.recording.recording import Recording, TopicRecording

WORDS = Words(__file__)

OF_THE_DRIVER = "/driver/"
"""The prefix of the driver's topics. The driver calls a student's functions, so these topics aren't the student's."""

ALIKE = 0.6
"""A name that is more similar than this to the required name (see `similar_share`) counts as a typo."""

P = ParamSpec("P")


@dataclass(frozen=True)
class _OnTopic:
    """A topic, and the recording in which it's judged."""

    recording: Recording
    topic: Topic

    @cached_property
    def seen(self) -> TopicRecording:
        return self.recording.topic(self.topic.name)


class _Publishing(_OnTopic):
    """A program's publishers, on the judged topic and on other topics."""

    @property
    def others(self) -> list[str]:
        """The types on the topic other than the required one."""
        return [name for name in self.seen.types if name != self.topic.type]

    @property
    def types(self) -> list[str]:
        return [name.rsplit("/", 1)[1] for name in self.seen.types]

    @cached_property
    def own(self) -> list[TopicRecording]:
        """The topics on which the student's program publishes, without the driver's topics."""
        topics = self.recording.with_publishers()
        return [other for other in topics if not other.name.startswith(OF_THE_DRIVER)]

    @property
    def names(self) -> list[str] | str:
        return [other.name for other in self.own] or "no topic"

    @cached_property
    def meant(self) -> str:
        """The name of an unexpected topic that was probably meant to be this topic, or "" if there is none."""
        strange = [other for other in self.own if other.name not in self.recording.wanted]
        others = [other.name for other in strange]
        wanted = self.topic.name
        base = wanted.rsplit("/", 1)[-1]
        of_type = [one.name for one in strange if self.topic.type in one.types and one.name != wanted]
        is_alike = len(of_type) == 1 and similar_share(of_type[0], wanted) > 0.5
        near = difflib.get_close_matches(wanted, others, 1, 0.75) or (of_type if is_alike else [""])
        return next((name for name in others if name.rsplit("/", 1)[-1] == base), near[0])

    @property
    def is_private(self) -> bool:
        owners = {publisher.node for publisher in self.recording.topic(self.meant).publishers}
        return any(
            self.topic.name.endswith(self.meant.removeprefix(owner))
            for owner in owners
            if self.meant.startswith(f"{owner}/")
        )

    @property
    def missing_namespace(self) -> str:
        return self.topic.name[: -len(self.meant)]

    @property
    def other_namespace(self) -> str:
        return self.meant[: -len(self.topic.name)]


_TYPES = WORDS.rules(
    _Publishing,
    "publishes",
    ("two-types", lambda one: one.topic.type in one.seen.types and one.others),
    ("other-type", lambda one: one.topic.type not in one.seen.types and one.seen.publishers),
)
_NAMES = WORDS.rules(
    _Publishing,
    "publishes",
    ("other-case", lambda one: one.meant.lower() == one.topic.name.lower()),
    ("private-name", lambda one: one.is_private),
    ("no-namespace", lambda one: one.topic.name.endswith(one.meant)),
    ("other-namespace", lambda one: one.meant.endswith(one.topic.name)),
    ("other-name", otherwise),
)
_BY_ERROR = WORDS.seen("publishes.by-error", _Publishing)
_NOTHING = WORDS.cause("publishes.nothing", _Publishing)


class _Arriving(_OnTopic):
    """The messages that arrive on a topic, and on its node's other topics."""

    @property
    def right(self) -> int:
        return len(self.seen.arrivals)

    @property
    def since(self) -> str:
        """The time of the first undecodable or too large message, as the end of a sentence, or "" if it's unknown."""
        return "" if self.seen.broken_at is None else f", the first at {seconds(self.seen.broken_at)}"

    @property
    def lasted(self) -> float:
        """The time (s) for which the topic was watched."""
        start, end = window_of(self.recording, self.seen)
        return end - start

    @property
    def lasted_until_full(self) -> float:
        """The time (s) for which the topic was watched before its quota of kept messages was used up."""
        start, _ = window_of(self.recording, self.seen)
        return max(0.0, (self.seen.full_at or 0.0) - start)

    @property
    def room(self) -> str:
        return count(self.right, "message") if self.seen.room is None else f"{self.seen.room / 1e6:g} MB"

    @cached_property
    def others(self) -> list[str]:
        """The exercise's other topics that the same node publishes, if they have more than one message."""
        nodes = {publisher.node for publisher in self.seen.publishers}
        talking = [one for one in other_topics(self.recording, self.topic) if len(one.arrivals) > 1]
        return [one.name for one in talking if nodes & {publisher.node for publisher in one.publishers}]

    @cached_property
    def going_on(self) -> list[str]:
        """The other topics that have messages until the end."""
        return [name for name in self.others if goes_on(self.recording, name)]

    @property
    def last_of_others(self) -> float:
        return max(self.recording.topic(name).arrivals[-1].t for name in self.others)

    @property
    def timer(self) -> str:
        if not self.topic.hz:
            return "Call"
        return f"Let create_timer({self.topic.period}, ...), which takes seconds, call"


_UNREADABLE = WORDS.rules(
    _Arriving,
    "no-message",
    ("undecodable", lambda one: one.seen.undecodable),
    ("too-large", lambda one: one.seen.not_kept and one.seen.full_at is None),
)
_NO_MESSAGE = WORDS.seen("no-message.by-error", _Arriving)
_PUBLISHER_THERE = WORDS.seen("no-message.publisher-there", _Arriving)
_SILENT = WORDS.rules(
    _Arriving,
    "no-message",
    ("silent", lambda one: not one.others),
    ("silent-beside-others", lambda one: one.going_on),
    ("all-stopped", otherwise),
    about_time=True,
)
_SOME_ARE_BROKEN = WORDS.rules(
    _Arriving,
    "all-kept",
    ("undecodable", lambda one: one.seen.undecodable),
    ("too-large", lambda one: one.seen.too_large),
)
_TOO_MUCH = WORDS.rules(_Arriving, "all-kept", ("too-much", lambda one: one.seen.full_at is not None))


def publishes(recording: Recording, topic: Topic) -> Verdict:
    """Check that the program publishes on `topic` with the right type, and with no other type."""
    one = _Publishing(recording, topic)
    of_type = _TYPES.first(one)
    if of_type is not None:
        return of_type
    if topic.type in one.seen.types:
        return passed(f"{topic.name} carries {topic.short_type}")
    if one.meant:
        return _NAMES.verdict(one)
    told = _BY_ERROR(one)
    early = failed_by_error(recording, *told) or held_by_a_spin(recording, *told)
    return early or _NOTHING.verdict(one)


def similar_share(one: str, other: str) -> float:
    """Return the similarity of two names, from 0 to 1."""
    return difflib.SequenceMatcher(None, one, other).ratio()


def misspelled(recording: Recording, wanted: str, names: Iterable[str]) -> str | None:
    """Return the unexpected name that was probably meant to be `wanted`, or None if no name is similar enough."""
    strange = sorted(set(names).difference(recording.wanted))
    near = max(strange, key=lambda name: similar_share(name, wanted), default=None)
    return near if near is not None and similar_share(near, wanted) > ALIKE else None


def no_message(recording: Recording, topic: Topic) -> Verdict | None:
    """Return a failed verdict if no message arrived on `topic`, or None otherwise."""
    one = _Arriving(recording, topic)
    if one.seen.arrivals:
        return None
    told = _NO_MESSAGE(one)
    early = (
        _UNREADABLE.first(one)
        or _TOO_MUCH.first(one)
        or failed_by_error(recording, *told, about_time=True)
        or program_ended(recording, *told)
    )
    if early is not None:
        return early
    told = _PUBLISHER_THERE(one)
    return (
        waits_for_clock(recording, topic, *told)
        or held_by_a_spin(recording, *told, of_a_spun_node=bool(one.others))
        or _SILENT.verdict(one)
    )


def if_messages(
    word: Callable[Concatenate[Recording, Topic, P], Verdict],
) -> Callable[Concatenate[Recording, Topic, P], Verdict]:
    """Decorate a function that judges a topic's messages, so that it returns `no_message` if none arrived."""

    @wraps(word)
    def judge(recording: Recording, topic: Topic, /, *args: P.args, **kwargs: P.kwargs) -> Verdict:
        return no_message(recording, topic) or word(recording, topic, *args, **kwargs)

    return judge


def if_all_kept(
    word: Callable[Concatenate[Recording, Topic, P], Verdict],
) -> Callable[Concatenate[Recording, Topic, P], Verdict]:
    """Decorate a function that judges every message on a topic, so that messages which can't be judged fail.

    The verdict fails if no message arrived, or if any message was undecodable or too large, even if the others are
    valid. It also fails if all recorded messages pass, but some weren't recorded because there were too many.
    """

    @wraps(word)
    def judge(recording: Recording, topic: Topic, /, *args: P.args, **kwargs: P.kwargs) -> Verdict:
        broken = no_message(recording, topic) or _SOME_ARE_BROKEN.first(_Arriving(recording, topic))
        if broken is not None:
            return broken
        verdict = word(recording, topic, *args, **kwargs)
        return (_TOO_MUCH.first(_Arriving(recording, topic)) if verdict.ok else None) or verdict

    return judge


def needs_messages(topic: Topic) -> Callable[[CriterionFunction], CriterionFunction]:
    """Decorate a judging function, so that it returns `no_message` if no message arrived on `topic`."""

    def guard(function: CriterionFunction) -> CriterionFunction:
        @wraps(function)
        def judge(recording: Recording) -> Verdict:
            return no_message(recording, topic) or function(recording)

        return judge

    return guard


def window_of(recording: Recording, seen: TopicRecording) -> tuple[float, float]:
    """Return the start and end (simulated time, s) of a topic's watch, or of the whole watch if it has no window."""
    start, end = seen.window if seen.window is not None else (0.0, recording.watched_s)
    return start, max(start, end)
