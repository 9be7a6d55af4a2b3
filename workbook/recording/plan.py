"""Plan a watch: the judged topics, the resolution and duration, and the judge's script."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from workbook.recording.script import NOTHING_SAID, Script

SPEEDS = (9.0, 20.0)
"""Robot seconds per real second if a program doesn't come to rest. Otherwise, the clock runs in lockstep with it."""
PERIODS_PER_BLOCK = 4.5
"""The length of a fast or slow block, in longest judged periods: long enough for three intervals of every topic."""
WALL_PERIODS = 4.0
WALL_EXTRA_S = 0.5
LEAST_WALL_WATCH_S = 4.0
STEPS_PER_PERIOD = 10
"""The default number of simulated time steps in the shortest judged period."""
BYTES_PER_TOPIC = 1_000_000
"""How many bytes of messages are kept for each topic by default. An array of twelve joint angles takes 80 bytes."""


Feature = Callable[[Any], Any]
"""A function that extracts the part of a message to keep: numbers, strings, and lists or dicts of them."""


@dataclass(frozen=True)
class Plan:
    """The judged topics and the script. They determine the resolution and duration of the watch.

    `topics`: judged topic names. `shortest_period` and `longest_period`: of the judged rates, in seconds. `paced`: the
    topics whose rate is judged. `simulated_seconds`: simulated time to watch; None: nine longest periods.
    `wall_seconds`: real time to watch on the wall clock; None: a little more than four longest periods. `script`: the
    judge's messages, services, and calls. With a script, a node alone shows that the program is up. `seed`: the
    script's seed; None if the script is the same in each run.

    `to_the_end`: whether the watch also looks for nodes that stay on the graph after the program's end. Then a
    participant that vanishes without a DDS dispose is remembered for much longer than a dispose takes on a busy
    machine. `bytes_per_topic`: how many bytes of messages are kept for each topic. `features`: by topic and field,
    functions that extract what to keep of large fields in addition to their beginning, size, and hash.
    `steps_per_period`: the number of simulated time steps in the shortest judged period.
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
        """Whether a node alone shows that the program is up, because it needn't publish anything by itself."""
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
