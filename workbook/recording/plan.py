"""Plan a watch: the judged topics, the resolution and duration, and the judge's script."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from workbook.recording.script import NOTHING_SAID, Script

SPEEDS = (9.0, 20.0)
"""Speeds of simulated time (simulated seconds per real second) for a program that never comes to rest.

For any other program, the clock runs in lockstep with the program.
"""
PERIODS_PER_BLOCK = 4.5
"""How long a fast or slow block lasts, as a multiple of the longest judged period.

That is long enough for three intervals of every topic.
"""
WALL_PERIODS = 4.0
WALL_EXTRA_S = 0.5
LEAST_WALL_WATCH_S = 4.0
STEPS_PER_PERIOD = 10
"""The default number of simulated time steps in the shortest judged period."""
BYTES_PER_TOPIC = 1_000_000
"""How many bytes of messages are kept for each topic by default. An array of twelve joint angles takes 80 bytes."""


Feature = Callable[[Any], Any]
"""A function that extracts the facts to keep from a message: numbers, strings, and lists or dicts of them."""


@dataclass(frozen=True)
class Plan:
    """The judged topics and the script, with the resolution and duration of the watch.

    `topics`: the names of the judged topics. `shortest_period` and `longest_period`: the shortest and longest period
    (s) among the judged rates. `paced`: the topics whose rate is judged. `simulated_seconds`: the simulated time to
    watch; if it's None, nine times the longest period. `wall_seconds`: the real time to watch on the wall clock; if
    it's None, a little more than four times the longest period. That's at least four seconds. `script`: the judge's
    messages, services, and calls. `seed`: the script's seed; None if the script is the same in each run.

    `to_the_end`: whether the watch also looks for nodes that stay in the graph after the program's end. If so, the
    judge remembers a participant that vanishes without a DDS dispose for a long time. That time is much longer than a
    dispose message takes on a busy machine. `bytes_per_topic`: how many bytes of messages are kept for each topic.
    `features`: functions, by topic and field, that extract facts about large fields. Those are kept in addition to the
    field's beginning, size, and hash. `steps_per_period`: the number of simulated time steps in the shortest judged
    period.
    """

    topics: tuple[str, ...]
    shortest_period: float
    longest_period: float
    simulated_seconds: float | None = None
    wall_seconds: float | None = None
    script: Script = NOTHING_SAID
    to_the_end: bool = False
    paced: tuple[str, ...] = ()
    bytes_per_topic: int = BYTES_PER_TOPIC
    features: Mapping[str, Mapping[str, Feature]] = field(default_factory=dict, compare=False)
    steps_per_period: int = STEPS_PER_PERIOD
    seed: int | None = None

    @property
    def node_suffices(self) -> bool:
        """Whether a node alone shows that the program is up, because the program may have nothing to publish yet."""
        return bool(self.script) or not self.topics

    @property
    def step_s(self) -> float:
        """The step of simulated time (s)."""
        return self.shortest_period / self.steps_per_period

    @property
    def simulated_s(self) -> float:
        """Simulated time to watch (s)."""
        return self.simulated_seconds or 2 * PERIODS_PER_BLOCK * self.longest_period

    @property
    def wall_s(self) -> float:
        """Real time (s) to watch on the wall clock."""
        return self.wall_seconds or max(LEAST_WALL_WATCH_S, WALL_PERIODS * self.longest_period + WALL_EXTRA_S)
