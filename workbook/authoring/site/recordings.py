"""Record the lessons' programs for the site: each message's effect on the robot, and the time of that effect.

`robots.toml` lists the robots. `record_all` runs their programs once and stores the effects as JSON in `recordings/`.
Building the site only reads these files.
"""

import json
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from workbook.authoring.tree import Tree
from workbook.lab.panel.reactions import MOMENTS, reaction_to
from workbook.recording.recording import Clock, Recording

FOLDER = Path(__file__).with_name("recordings")
COMPANIONS = Path(__file__).with_name("companions")
TABLE = Path(__file__).with_name("robots.toml")
_DIGITS = 3


@dataclass(frozen=True)
class SiteRobot:
    """A robot on a page: the cell that it follows, and the program whose recording moves it.

    `program` is the name of a lesson's program, or another program's path. `topics` maps each recorded topic to its
    period in seconds. `ease` is the time (s) that the robot takes to reach a pose. `slider` is the parameter that has
    one recording for each of `values`, or an empty string if there is no slider.
    """

    lesson: str
    program: str
    topics: dict[str, float]
    seconds: float
    cell: str = ""
    about: str = ""
    parameters: dict[str, Any] = field(default_factory=dict)
    ease: float = 0.0
    slider: str = ""
    values: tuple[float, ...] = ()
    value: float = 0.0
    clock: Clock = "simulated"
    companion: str = ""
    """The module of a second node in the same process, in `lesson_nodes/` or `companions/`, or an empty string."""
    plays: str = ""
    """The name of another robot's recording to play, or an empty string if the robot has its own."""

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the robot's recordings: one for each slider value, or a single one."""
        if self.plays:
            return (self.plays,)
        name = f"{self.lesson}-{self.cell or 'title'}"
        return tuple(f"{name}-{value:g}" for value in self.values) or (name,)

    def runs(self) -> Iterator[tuple[str, dict[str, Any]]]:
        """Yield the name of each recording to make for this robot, and the parameters of its run."""
        if not self.values and not self.plays:
            yield self.names[0], self.parameters
        for name, value in zip(self.names, self.values, strict=False):
            yield name, {**self.parameters, self.slider: value}


@cache
def site_robots() -> tuple[SiteRobot, ...]:
    """Return the robots in `robots.toml`."""
    robots: list[SiteRobot] = []
    for row in tomllib.loads(TABLE.read_text(encoding="utf-8"))["robot"]:
        if "plays" in row:
            played = next(one for one in robots if one.names == (row["plays"],))
            robots.append(replace(played, **{"cell": "", **row}))
        else:
            robots.append(SiteRobot(**{**row, "values": tuple(row.get("values", ()))}))
    return tuple(robots)


def recording_file(name: str) -> Path:
    """Return a recording's path."""
    return FOLDER / f"{name}.json"


def record_all(tree: Tree, only: str = "") -> Iterator[Path]:
    """Run the programs of all recordings whose names contain `only`, and yield each file after storing it."""
    FOLDER.mkdir(exist_ok=True)
    for robot in site_robots():
        for name, parameters in robot.runs():
            if only in name:
                recording_file(name).write_text(_recorded(tree, robot, parameters), encoding="utf-8")
                yield recording_file(name)


def _recorded(tree: Tree, robot: SiteRobot, parameters: dict[str, Any]) -> str:
    from workbook.lesson.programs import record
    from workbook.ros.scratch import scratch_folder

    folder = tree.root if "/" in robot.program else tree.lesson_nodes
    program = folder / f"{robot.program}.py"
    if robot.companion:
        program = scratch_folder("site") / f"{robot.program}.py"
        program.write_text(_both(robot), encoding="utf-8")
    seen = record(program, robot.topics, robot.seconds + 1, robot.clock, **parameters)
    events = effects_of(seen, robot)
    return json.dumps({"seconds": robot.seconds, "events": events}, separators=(",", ":")) + "\n"


def _both(robot: SiteRobot) -> str:
    """Return the code of a program that spins both the program's node and its companion."""
    nodes = [
        (name, "".join(map(str.capitalize, name.split("_")))) for name in (robot.program, robot.companion)
    ]
    lines = ["import rclpy", "from rclpy.executors import SingleThreadedExecutor"]
    for module, name in nodes:
        is_own = (COMPANIONS / f"{module}.py").is_file()
        package = "workbook.authoring.site.companions" if is_own else "lesson_nodes"
        lines.append(f"from {package}.{module} import {name}")
    lines += ["rclpy.init()", "executor = SingleThreadedExecutor()"]
    lines += [f"executor.add_node({name}())" for _, name in nodes]
    return "\n".join([*lines, "executor.spin()", ""])


def effects_of(recording: Recording, robot: SiteRobot) -> list[list[Any]]:
    """Return each message's effect on the robot as `[seconds, effect, value]`, in chronological order from 0 s on.

    Raises ValueError if there are no messages, or if the robot doesn't react to one of the topics.
    """
    events: list[list[Any]] = []
    for name in robot.topics:
        topic = recording.topic(name)
        for arrival in topic.arrivals:
            reaction = reaction_to(name, topic.types[0])
            if reaction is None:
                raise ValueError(f"no reaction to {name}")
            effect = 1 if reaction.effect in MOMENTS else _short(reaction.value(_message(arrival.value)))
            events.append([arrival.t, reaction.effect, effect])
    if not events:
        raise ValueError(f"{robot.program} published nothing")
    events.sort(key=lambda event: event[0])
    begin = events[0][0]
    timed = ([round(t - begin, _DIGITS), effect, value] for t, effect, value in events)
    return [event for event in timed if event[0] <= robot.seconds]


def _message(value: Any) -> Any:
    """Return a recorded message as an object with attributes, because reactions read attributes."""
    if isinstance(value, dict):
        return SimpleNamespace(**{name: _message(part) for name, part in value.items()})
    return value


def _short(value: Any) -> Any:
    if isinstance(value, list):
        return [_short(part) for part in value]
    return round(value, _DIGITS) if isinstance(value, float) else value
