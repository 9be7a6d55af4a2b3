"""What is to be watched: how finely and how long, and what is said meanwhile."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from workbook.recording.script import NOTHING_SAID, Script

SPEEDS = (9.0, 20.0)
"""Robot seconds per real second for a program that does not come to rest; else the clock goes in lock-step with it."""
PERIODS_PER_BLOCK = 4.5
"""Of the longest judged period: a fast block, then a slow one, each long enough for three intervals of every topic."""
WALL_PERIODS = 4.0
WALL_EXTRA_S = 0.5
LEAST_WALL_WATCH_S = 4.0
STEPS_PER_PERIOD = 10
"""Steps of simulated time in the shortest judged period, where an exercise says nothing else."""
BYTES_PER_TOPIC = 1_000_000
"""How much is kept of a topic, where an exercise says nothing else. A joint array of twelve angles takes 80 bytes."""


Feature = Callable[[Any], Any]
"""What is kept of a field: given the message, it returns numbers, texts, and lists or dicts of them."""


@dataclass(frozen=True)
class Plan:
    """What is to be judged, so that the watch knows how finely and how long to record.

    `topics`: judged topic names. `shortest_period` and `longest_period`: of the judged rates, in seconds.
    `paced`: those of them whose rate is judged. `simulated_seconds`: simulated time to watch; None: nine of the longest
    period. `wall_seconds`: real time to watch on the wall clock; None: a little more than four of the longest period.
    `script`: what the judge sends meanwhile. A program that only listens is then seen by its node. `seed`: what the
    script was drawn from; None for one that is the same in each run. `to_the_end`: whether the watch also looks for
    nodes that stay on the graph after the program. A participant that vanishes without a DDS dispose is then remembered
    for much longer than a dispose takes on the busiest machine. `bytes_per_topic`: how many bytes of messages are kept
    of each topic. `features`: by topic and field, what is kept of large fields besides their beginning, size and hash.
    `steps_per_period`: into how many steps of simulated time the shortest judged period is divided.
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
        """Whether a node alone is a sign of life: where nothing has to be published before something was said."""
        return bool(self.script) or not self.topics

    @property
    def step_s(self) -> float:
        """Step of simulated time (s)."""
        return self.shortest_period / self.steps_per_period

    @property
    def simulated_s(self) -> float:
        """Simulated time to watch (s)."""
        return self.simulated_seconds or 2 * PERIODS_PER_BLOCK * self.longest_period

    @property
    def wall_s(self) -> float:
        """Real time (s) to watch on the wall clock."""
        return self.wall_seconds or max(LEAST_WALL_WATCH_S, WALL_PERIODS * self.longest_period + WALL_EXTRA_S)
