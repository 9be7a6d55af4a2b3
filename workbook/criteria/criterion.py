"""What a criterion is: one judged statement about a recording, with points."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from random import Random
from types import ModuleType
from typing import Any

from workbook.criteria.verdict import Verdict
from workbook.recording.plan import BYTES_PER_TOPIC, STEPS_PER_PERIOD, Feature, Plan
from workbook.recording.recording import Recording
from workbook.recording.script import NOTHING_SAID, Part, Script
from workbook.recording.type_names import type_name

CriterionFunction = Callable[[Recording], Verdict]
Draw = Callable[[Random], Sequence[Part]]
"""Makes the parts of a script from random numbers."""


@dataclass(frozen=True)
class Criterion:
    """A judged statement about a recording. It is skipped unless every criterion in `needs` passes.

    `about_end`: it judges how the program ends, and not what it does until then.
    """

    id: str
    title: str
    points: float
    needs: tuple["Criterion", ...]
    hidden: bool
    judge: CriterionFunction = field(compare=False)
    about_end: bool = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "__doc__", self.judge.__doc__)

    def __call__(self, recording: Recording) -> Verdict:
        return self.judge(recording)


def criterion(
    *,
    points: float,
    title: str,
    needs: Sequence[Criterion] = (),
    hidden: bool = False,
    about_end: bool = False,
) -> Callable[[CriterionFunction], Criterion]:
    """Make a criterion of a function that takes a recording and returns a verdict.

    `points` may be 0 for a condition that only others need. `about_end`: it judges how the program ends, which a bug in
    rclpy or Python may spoil. Raises ValueError for negative points or no title.
    """
    if points < 0:
        raise ValueError(f"points are never negative: {points}")
    if not title.strip():
        raise ValueError("a criterion needs a title: it is what the student reads")

    def make(function: CriterionFunction) -> Criterion:
        return Criterion(function.__name__, title, points, tuple(needs), hidden, function, about_end)

    return make


@dataclass(frozen=True)
class Topic:
    """A topic that an exercise asks for: its name, message type and rate in Hz (None if no rate is judged).

    `features` and `signed`: see `topic`.
    """

    name: str
    type: str
    hz: float | None = None
    features: Mapping[str, Feature] = field(default_factory=dict, compare=False)
    signed: bool = False

    @property
    def short_type(self) -> str:
        """The type as one writes it in Python, e.g. "Float32"."""
        return self.type.rsplit("/", 1)[1]

    @property
    def period(self) -> float:
        """Seconds between two messages. Raises ValueError when no rate is judged."""
        if self.hz is None:
            raise ValueError(f"{self.name} has no rate to judge")
        return 1.0 / self.hz


def topic(
    name: str,
    message_class: Any,
    hz: float | None = None,
    *,
    features: Mapping[str, Feature] | None = None,
    signed: bool = False,
) -> Topic:
    """Declare a topic that criteria judge, e.g. `topic("/robot/battery", Float32, hz=0.5)`.

    `features`: for messages with large fields, such as images: by field, a function that is given the message and
    returns what criteria want to know of it (numbers, texts, lists, dicts). The field itself is kept as `{"length": n,
    "sha256": "...", "first": [...], "features": what was returned}`; None is kept where the function raised something.

    `signed`: the driver publishes it, and signs each message. Criteria see only what it has signed.
    """
    return Topic(name, type_name(message_class), hz, features or {}, signed)


@dataclass(frozen=True)
class Watching:
    """How the recording of an exercise is made, where it differs from the usual.

    `script`: the same in each run, or the function that draws one.
    """

    simulated_seconds: float | None = None
    wall_seconds: float | None = None
    to_the_end: bool = False
    script: Script | Draw = NOTHING_SAID
    bytes_per_topic: int = BYTES_PER_TOPIC
    steps_per_period: int = STEPS_PER_PERIOD

    def drawn(self, plan: Plan, seed: int) -> Plan:
        """The plan with a script drawn from `seed`; the same plan where the script is the same in each run."""
        if isinstance(self.script, Script):
            return plan
        return replace(plan, script=Script(tuple(self.script(Random(seed)))), seed=seed)


def watching(
    *,
    simulated_seconds: float | None = None,
    wall_seconds: float | None = None,
    to_the_end: bool = False,
    script: Sequence[Part] | Draw = (),
    bytes_per_topic: int = BYTES_PER_TOPIC,
    steps_per_period: int = STEPS_PER_PERIOD,
) -> Watching:
    """Declare how to watch, once per criteria file.

    `simulated_seconds`: simulated time to watch in all, instead of nine of the longest period. `wall_seconds`: real
    time to watch on the wall clock, instead of four of the longest period. `to_the_end`: the program is sent Ctrl-C
    (SIGINT) before it is judged, so that criteria see how it ends, and which of its nodes stay on the graph. `script`:
    the messages, services and calls that the judge sends to the program meanwhile, made with `publish`, `serves` and
    `calls`. A program could answer a fixed script from a table. So `script` may be a function: given a `random.Random`,
    it draws them again for each run. What matters to the criteria must be in each draw, and they judge by what the
    recording says (`published`, `calls`). `bytes_per_topic`: how many bytes of messages are kept of each topic, those
    of the judge not counted. Of a field with more than 4096 elements only the beginning, the size and the SHA-256 are
    kept, and hardly more is counted. `steps_per_period`: into how many steps of simulated time the shortest judged
    period is divided. Each step costs about two milliseconds: fewer of them make a long watch of a fast topic quicker.
    """
    return Watching(
        simulated_seconds,
        wall_seconds,
        to_the_end,
        script if callable(script) else Script(tuple(script)),
        bytes_per_topic,
        steps_per_period,
    )


def watching_in(module: ModuleType) -> Watching:
    """How a criteria module wants to watch."""
    return next((value for value in vars(module).values() if isinstance(value, Watching)), Watching())


def criteria_in(module: ModuleType) -> tuple[Criterion, ...]:
    """The criteria that a module defines, in the order of their definition."""
    return tuple(value for value in vars(module).values() if isinstance(value, Criterion))


def topics_in(module: ModuleType) -> tuple[Topic, ...]:
    """The topics that a module declares."""
    return tuple(value for value in vars(module).values() if isinstance(value, Topic))


def plan_for(topics: Iterable[Topic], how: Watching) -> Plan:
    """How finely and how long to watch for these topics. A script that is drawn is missing: see `Watching.drawn`."""
    declared = tuple(topics)
    periods = [one.period for one in declared if one.hz is not None] or [1.0]
    return Plan(
        tuple(one.name for one in declared),
        min(periods),
        max(periods),
        how.simulated_seconds,
        how.wall_seconds,
        how.script if isinstance(how.script, Script) else NOTHING_SAID,
        how.to_the_end,
        tuple(one.name for one in declared if one.hz is not None),
        how.bytes_per_topic,
        {one.name: one.features for one in declared if one.features},
        how.steps_per_period,
    )
