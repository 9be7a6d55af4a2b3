"""What full marks bring onto a card: the student's own robot moves, the points gained, what comes next."""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, cast

from workbook.exercise.source import DEEPER
from workbook.recording.recording import Recording

POSES = 5
"""Poses of the recording that the robot goes through: three seconds of film."""
POSE_S = 0.6
FRAMES_PER_S = 10
WAVE_S = 2.7
SCALE = 0.75
Lamp = Literal["operational", "error"]


@dataclass(frozen=True)
class Film:
    """The robot in motion (WebP), its last picture (PNG) for those who want no motion, and both in words."""

    moving: bytes
    still: bytes
    text: str


@dataclass(frozen=True)
class Moment:
    """What a card with full marks shows besides the judgement. `film` follows when it is drawn."""

    gained: str = ""
    next_title: str = ""
    next_link: str = ""
    film: Film | None = None


def gained(before: float, now: float, solved: int, of: int) -> str:
    """What this check earned, in words, and how many exercises are solved now."""
    if now > before > 0:
        points = f"{now - before:g} more {_points(now - before)} than before. "
    elif now > before:
        points = f"You gained {now:g} {_points(now)}. "
    else:
        points = "You had these points already, and they stay yours. "
    return f"{points}{solved} of {of} exercises solved."


def _points(number: float) -> str:
    return "point" if number == 1 else "points"


def what_comes_next(course: Path, stem: str) -> tuple[str, str]:
    """Title and link, as seen from the exercise, of the lesson after it; both empty after the last one."""
    lessons = sorted((course / "notebooks").glob("[0-9][0-9]_*.ipynb"))
    later = [path for path in lessons if path.stem > stem and not path.stem.endswith(DEEPER)]
    if not later:
        return "", ""
    cells = json.loads(later[0].read_text(encoding="utf-8"))["cells"]
    first = next(iter("".join(cells[0]["source"]).splitlines()), later[0].stem)
    return first.lstrip("# ").strip(), f"../notebooks/{later[0].name}"


def film_of(recording: Recording) -> Film:
    """The robot as the recording tells it: through the poses that the program sent; it waves if there were none."""
    # Matplotlib takes half a second to import: too long for a grader, which draws nothing.
    from workbook.pictures import humanoid
    from workbook.pictures.film import film
    from workbook.pictures.joints import Follower, waving

    poses = list(_poses(recording))[:POSES]
    pictures = []
    if poses:
        follower = Follower(ease=0.75 * POSE_S)
        for number in range(round(len(poses) * POSE_S * FRAMES_PER_S)):
            t = number / FRAMES_PER_S
            angles, lamp = poses[int(t / POSE_S)]
            if number == 0 or int(t / POSE_S) != int((number - 1) / FRAMES_PER_S / POSE_S):
                follower.aim(angles, t)
            pictures.append(humanoid.draw(follower.angles(t), lamp=lamp, scale=SCALE))
        pictures.append(humanoid.draw(poses[-1][0], lamp=poses[-1][1], scale=SCALE))
        first = "first pose" if len(poses) == 1 else f"first {len(poses)} poses"
        text = f"Your robot moves through the {first} that your program sent."
    else:
        lamp = _lamp(recording, recording.simulated_s)
        for number in range(round(WAVE_S * FRAMES_PER_S)):
            pictures.append(humanoid.draw(waving(number / FRAMES_PER_S), lamp=lamp, scale=SCALE))
        text = "The robot waves."
    return Film(film(pictures, per_second=FRAMES_PER_S), pictures[-1], text)


def _poses(recording: Recording) -> Iterator[tuple[tuple[float, ...], Lamp | None]]:
    """Twelve angles and the lamp, for each message that holds a pose of the robot."""
    from workbook.pictures.joints import checked

    for topic in recording.with_publishers():
        if not any(kind.endswith("MultiArray") for kind in topic.types):
            continue
        for arrival in topic.arrivals:
            try:
                yield checked(arrival.value["data"]), _lamp(recording, arrival.t)
            except (ValueError, TypeError, KeyError):
                continue


def _lamp(recording: Recording, t: float) -> Lamp | None:
    """The last status that the program had sent at the simulated time `t`."""
    for topic in recording.with_publishers():
        if topic.name.endswith("/status"):
            words = [
                one.value.get("data") for one in topic.arrivals if one.t <= t and isinstance(one.value, dict)
            ]
            known = [word for word in words if word in ("operational", "error")]
            return cast(Lamp, known[-1]) if known else None
    return None
