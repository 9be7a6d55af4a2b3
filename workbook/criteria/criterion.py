"""Define criteria, along with the topics and the watch that they need."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from random import Random
from types import ModuleType
from typing import Any

from workbook.criteria.verdict import Verdict
from workbook.recording.plan import BYTES_PER_TOPIC, STEPS_PER_PERIOD, Feature, Plan
from workbook.recording.recording import Recording
from workbook.recording.script import EMPTY_SCRIPT, Part, Script
from workbook.recording.type_names import type_name

CriterionFunction = Callable[[Recording], Verdict]
Draw = Callable[[Random], Sequence[Part]]
"""A function that generates a script's parts from random numbers."""


@dataclass(frozen=True)
class Criterion:
    """A judged statement about a recording. It's skipped unless every criterion in `needs` passes.

    `about_end`: whether the criterion judges how the program exits, rather than how the program behaves until then.
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
    """Turn a function that takes a recording and returns a verdict into a criterion.

    `points` may be 0 for a condition that only other criteria need. `about_end`: whether the criterion judges how the
    program exits. Such results are treated separately, because a bug in rclpy or Python may spoil a correct program's
    exit. Raises ValueError if the points are negative or the title is empty.
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
    """A topic that an exercise requires: its name, message type, and rate in Hz (None if no rate is judged).

    For `features` and `signed`, see the function `topic`.
    """

    name: str
    type: str
    hz: float | None = None
    features: Mapping[str, Feature] = field(default_factory=dict, compare=False)
    signed: bool = False

    @property
    def short_type(self) -> str:
        """The type's class name in Python, such as "Float32"."""
        return self.type.rsplit("/", 1)[1]

    @property
    def package(self) -> str:
        """The type's package, such as "std_msgs"."""
        return self.type.split("/")[0]

    @property
    def period(self) -> float:
        """The time between two messages (s). Raises ValueError if no rate is judged."""
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

    `features`: for messages with large fields, such as images, a mapping from a field's name to a function. The
    function takes the message and returns the facts that criteria need (numbers, strings, lists, dicts). The field
    itself is stored as `{"length": n, "sha256": "...", "first": [...], "features": the returned facts}`. The facts are
    None if the function raised an exception.

    `signed`: whether the driver publishes this topic. The driver signs each message, and criteria see only signed
    messages.
    """
    return Topic(name, type_name(message_class), hz, features or {}, signed)


@dataclass(frozen=True)
class Watching:
    """The settings for recording an exercise (see the function `watching`).

    `script`: a fixed script, or a function that draws a new script for each run.
    """

    simulated_seconds: float | None = None
    wall_seconds: float | None = None
    to_the_end: bool = False
    script: Script | Draw = EMPTY_SCRIPT
    bytes_per_topic: int = BYTES_PER_TOPIC
    steps_per_period: int = STEPS_PER_PERIOD

    def drawn(self, plan: Plan, seed: int) -> Plan:
        """Return the plan with a script drawn from `seed`, or the plan itself if the script is fixed."""
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
    """Declare how the judge watches the program, once per criteria file.

    `simulated_seconds`: the simulated time to watch; by default, nine times the longest period. `wall_seconds`: the
    real time to watch on the wall clock; by default, four times the longest period. `to_the_end`: send the program
    Ctrl-C (SIGINT) before judging it, so that criteria see how it exits and which of its nodes stay in the graph.

    `script`: the messages, services, and calls that the judge sends to the program, made with `publish`, `serves`, and
    `calls`. A program could respond to a fixed script from a table. To prevent that, `script` may be a function that
    takes a `random.Random` and draws new parts for each run. Every draw must contain everything that the criteria need.
    The criteria must then compare with the script as recorded (`published`, `calls`).

    `bytes_per_topic`: the number of bytes of messages that are kept per topic, not counting the judge's messages. A
    field with more than 4096 elements is cut to its beginning, its size, and its SHA-256, so it hardly counts toward
    this limit. `steps_per_period`: the number of steps of simulated time per shortest judged period. Each step takes
    about two milliseconds, so fewer steps speed up a long watch of a fast topic.
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
    """Return the `Watching` that a criteria module declares, or the default one."""
    return next((value for value in vars(module).values() if isinstance(value, Watching)), Watching())


def criteria_in(module: ModuleType) -> tuple[Criterion, ...]:
    """Return the criteria that a module defines, in the order of their definition."""
    return tuple(value for value in vars(module).values() if isinstance(value, Criterion))


def topics_in(module: ModuleType) -> tuple[Topic, ...]:
    """Return the topics that a module declares."""
    return tuple(value for value in vars(module).values() if isinstance(value, Topic))


def plan_for(topics: Iterable[Topic], how: Watching) -> Plan:
    """Return the plan for watching these topics, with the step of simulated time and the duration of the watch.

    The plan doesn't include a script that is drawn for each run, which `Watching.drawn` adds.
    """
    declared = tuple(topics)
    periods = [one.period for one in declared if one.hz is not None] or [1.0]
    return Plan(
        tuple(one.name for one in declared),
        min(periods),
        max(periods),
        how.simulated_seconds,
        how.wall_seconds,
        how.script if isinstance(how.script, Script) else EMPTY_SCRIPT,
        how.to_the_end,
        tuple(one.name for one in declared if one.hz is not None),
        how.bytes_per_topic,
        {one.name: one.features for one in declared if one.features},
        how.steps_per_period,
    )
