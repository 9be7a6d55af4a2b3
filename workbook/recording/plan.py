"""Define the plan of a watch: the judged topics, the time resolution, the duration, and the judge's script.

In a watch, the judge runs a program and records its effects.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from workbook.recording.script import EMPTY_SCRIPT, Script

SPEEDS = (9.0, 20.0)
"""The speeds of simulated time (simulated seconds per real second) for a program that never comes to rest.

For any other program, simulated time runs in lockstep: the clock steps when the program is at rest.
"""
PERIODS_PER_BLOCK = 4.5
"""The duration of a block, which has one of the two speeds, as a multiple of the longest judged period.

A block of this duration contains at least three intervals between messages of every topic.
"""
WALL_PERIODS = 4.0
WALL_EXTRA_S = 0.5
LEAST_WALL_WATCH_S = 4.0
STEPS_PER_PERIOD = 10
"""The default number of simulated time steps in the shortest judged period."""
BYTES_PER_TOPIC = 1_000_000
"""The default limit on the bytes of messages that are kept for each topic.

An array of twelve joint angles takes 80 bytes.
"""


Feature = Callable[[Any], Any]
"""A function that extracts facts from a message's field.

Its result consists of numbers, strings, and lists or dicts of those.
"""


@dataclass(frozen=True)
class Plan:
    """The judged topics and the script, with the time resolution and the duration of the watch.

    `topics`: the names of the judged topics. `shortest_period` and `longest_period`: the shortest and longest period
    (s) among the judged rates. `paced`: the topics whose rate is judged. `simulated_seconds`: the simulated time to
    watch, or None for nine times the longest period. `wall_seconds`: the real time to watch on the wall clock. None
    means four times the longest period plus half a second, but at least four seconds. `script`: the judge's messages,
    services, and calls. `seed`: the script's seed, or None if the script is the same in each run.

    `to_the_end`: whether the watch also looks for nodes that are still in the graph after the program has exited. If
    so, a DDS participant that vanishes without a dispose message stays in the judge's graph for a long time. That time
    is much longer than a dispose message takes on a busy machine, so a node that's still there didn't send one.
    `bytes_per_topic`: the limit on the bytes of messages that are kept for each topic. `features`: functions, by topic
    and field, that extract facts about large fields. The facts are kept in addition to the field's beginning, size, and
    hash. `steps_per_period`: the number of simulated time steps in the shortest judged period.
    """

    topics: tuple[str, ...]
    shortest_period: float
    longest_period: float
    simulated_seconds: float | None = None
    wall_seconds: float | None = None
    script: Script = EMPTY_SCRIPT
    to_the_end: bool = False
    paced: tuple[str, ...] = ()
    bytes_per_topic: int = BYTES_PER_TOPIC
    features: Mapping[str, Mapping[str, Feature]] = field(default_factory=dict, compare=False)
    steps_per_period: int = STEPS_PER_PERIOD
    seed: int | None = None

    @property
    def node_suffices(self) -> bool:
        """Whether the program counts as started once it has a node, because it may not publish anything yet."""
        return bool(self.script) or not self.topics

    @property
    def step_s(self) -> float:
        """The length of a step of simulated time (s)."""
        return self.shortest_period / self.steps_per_period

    @property
    def simulated_s(self) -> float:
        """The simulated time to watch (s)."""
        return self.simulated_seconds or 2 * PERIODS_PER_BLOCK * self.longest_period

    @property
    def wall_s(self) -> float:
        """The real time to watch on the wall clock (s)."""
        return self.wall_seconds or max(LEAST_WALL_WATCH_S, WALL_PERIODS * self.longest_period + WALL_EXTRA_S)
