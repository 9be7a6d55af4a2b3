"""Show the reward for full marks on a card: the student's own robot moves, next to the points and the next step."""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Literal, cast

from workbook.exercise.source import DEEPER
from workbook.recording.recording import Recording

POSES = 5
"""The most recorded poses that the robot moves through, in an animation of three seconds."""
POSE_S = 0.6
FRAMES_PER_S = 10
WAVE_S = 2.7
SCALE = 0.75
Lamp = Literal["operational", "error"]


@dataclass(frozen=True)
class Film:
    """An animation of the robot, with a description.

    `moving`: the animation (WebP), or b"" if the front end animates the robot itself. `still`: the last frame (PNG),
    for readers who prefer reduced motion.
    """

    moving: bytes
    still: bytes
    text: str


@dataclass(frozen=True)
class Moment:
    """The extras on the card of an answer with full marks.

    `film`: the animation, or None until it has been rendered. `replays`: whether the front end animates the robot from
    the recording. Such an animation needs more room than a still image.
    """

    gained: str = ""
    next_title: str = ""
    next_link: str = ""
    film: Film | None = None
    replays: bool = False


def gained(before: float, now: float, solved: int, of: int) -> str:
    """Describe the points that this check earned, and the number of exercises solved so far."""
    if now > before > 0:
        points = f"{now - before:g} more {_points(now - before)} than before. "
    elif now > before:
        points = f"You gained {now:g} {_points(now)}. "
    else:
        points = "You already had these points, and you keep them. "
    return f"{points}{solved} of {of} exercises solved."


def _points(number: float) -> str:
    return "point" if number == 1 else "points"


def what_comes_next(course: Path, stem: str) -> tuple[str, str]:
    """Return the next lesson's title and its link, relative to the exercise. After the last lesson, both are empty."""
    lessons = sorted((course / "notebooks").glob("[0-9][0-9]_*.ipynb"))
    later = [path for path in lessons if path.stem > stem and not path.stem.endswith(DEEPER)]
    if not later:
        return "", ""
    cells = json.loads(later[0].read_text(encoding="utf-8"))["cells"]
    first = next(iter("".join(cells[0]["source"]).splitlines()), later[0].stem)
    return first.lstrip("# ").strip(), f"../notebooks/{later[0].name}"


def still_of(recording: Recording) -> Film:
    """Return a film with only the last frame, for a front end that animates the robot itself."""
    from workbook.pictures import humanoid
    from workbook.pictures.joints import waving

    poses = list(islice(_poses(recording), POSES))
    if poses:
        angles, lamp = poses[-1]
        return Film(
            b"", humanoid.draw(angles, lamp=lamp, scale=SCALE), "Your robot in a pose that your program sent."
        )
    lamp = _lamp(recording, recording.watched_s)
    return Film(b"", humanoid.draw(waving(WAVE_S), lamp=lamp, scale=SCALE), "The robot waves.")


def film_of(recording: Recording) -> Film:
    """Return a film of the robot moving through the first poses that the program sent.

    If the program didn't send any poses, the robot waves.
    """
    # Importing Matplotlib takes half a second, which is too long for grading, because it doesn't draw anything.
    from workbook.pictures import humanoid
    from workbook.pictures.film import film
    from workbook.pictures.joints import Follower, waving

    poses = list(islice(_poses(recording), POSES))
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
        lamp = _lamp(recording, recording.watched_s)
        for number in range(round(WAVE_S * FRAMES_PER_S)):
            pictures.append(humanoid.draw(waving(number / FRAMES_PER_S), lamp=lamp, scale=SCALE))
        text = "The robot waves."
    return Film(film(pictures, per_second=FRAMES_PER_S), pictures[-1], text)


def _poses(recording: Recording) -> Iterator[tuple[tuple[float, ...], Lamp | None]]:
    """Yield, for each message with a pose, the pose's twelve angles and the lamp's state at that time."""
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
    """Return the last valid status that the program sent by simulated time `t` (s), or None if it sent none."""
    for topic in recording.with_publishers():
        if topic.name.endswith("/status"):
            words = [
                one.value.get("data") for one in topic.arrivals if one.t <= t and isinstance(one.value, dict)
            ]
            known = [word for word in words if word in ("operational", "error")]
            return cast(Lamp, known[-1]) if known else None
    return None
