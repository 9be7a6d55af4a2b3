"""Exercise 15 on recordings made by hand: one fault loses what the table says."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import pytest

from tests.criteria.by_hand import publisher, recorded
from workbook.criteria.runner import run_criteria
from workbook.exercise.course import course_folder
from workbook.exercise.definition import load_exercise
from workbook.recording.recording import Arrival, Published, Recording, SubscriberSeen, TopicRecording

CRITERIA = load_exercise("15_camera", course_folder()).criteria
NAMES: dict[str, Any] = CRITERIA[-1].judge.__globals__
SEED = 3
SHOWN = NAMES["drawn"](SEED)
SENT = [0.5 + place / 30 for place in range(NAMES["PICTURES"])]
IMAGE, DIRECTION = "/camera/image", "/robot/ball_direction"
LOG = "\n".join(f"[ERROR] [tracker]: cannot read {name}" for name in NAMES["REFUSED"])
Vector = tuple[float, float, float]
Message = tuple[float, int, Vector]
"""When it arrived (s), the index of the image with its stamp, and its direction."""


def right_ones() -> list[Message]:
    """Return the ball's direction in each readable image."""
    return [
        (SENT[place] + 0.02, place, SHOWN.balls.get(place, (0.0, 0.0, 0.0)))
        for place in sorted(SHOWN.readable)
    ]


def recording(messages: Sequence[Message]) -> Recording:
    arrivals = []
    for at, place, (x, y, z) in messages:
        sec, nanosec = SHOWN.views[place].stamp if place >= 0 else (0, 0)
        value = {"header": {"stamp": {"sec": sec, "nanosec": nanosec}}, "vector": {"x": x, "y": y, "z": z}}
        arrivals.append(Arrival(at, at, value))
    kind = "geometry_msgs/msg/Vector3Stamped"
    made = recorded(TopicRecording(DIRECTION, (publisher(kind),), (), tuple(arrivals), (0.0, 8.0)))
    heard = SubscriberSeen("/tracker", "sensor_msgs/msg/Image", "reliable", "volatile")
    return replace(
        made,
        topics={**made.topics, IMAGE: TopicRecording(IMAGE, (), (heard,))},
        published=tuple(Published(IMAGE, at, at, {}) for at in SENT),
        process=replace(made.process, log=LOG),
        seed=SEED,
    )


def lost(messages: Sequence[Message]) -> dict[str, str]:
    """Return the criteria that don't pass, with their causes."""
    results = run_criteria(CRITERIA, recording(messages))
    return {one.id: one.cause or one.status for one in results if one.status != "passed"}


def test_a_good_recording_gets_full_marks() -> None:
    assert lost(right_ones()) == {}


def ten_a_second(first: int) -> list[Message]:
    """Answer only every third image, as a timer that uses the newest image would."""
    return [one for one in right_ones() if one[1] % 3 == first]


@pytest.mark.parametrize("first", range(3))
def test_ten_answers_a_second_cost_the_point_for_keeping_up(first: int) -> None:
    assert set(lost(ten_a_second(first))) == {"keeps_up"}


def twice() -> list[Message]:
    return [(at + later, place, vector) for at, place, vector in right_ones() for later in (0.0, 0.001)]


def half_again() -> list[Message]:
    return right_ones() + [(8.0, place, vector) for _, place, vector in right_ones() if place % 2]


@pytest.mark.parametrize("messages", [twice, half_again])
def test_two_answers_for_a_picture_cost_the_point_for_stamps(messages: Callable[[], list[Message]]) -> None:
    assert lost(messages()) == {"stamps_kept": "stamps-kept.repeated"}


def with_blue(chosen: Callable[[int], bool]) -> list[Message]:
    return [
        (at, place, SHOWN.blue_balls[place] if place in SHOWN.balls and chosen(place) else vector)
        for at, place, vector in right_ones()
    ]


@pytest.mark.parametrize("share", [2, 3, 4])
def test_a_node_that_also_follows_the_blue_ball_has_not_exchanged_the_colors(share: int) -> None:
    assert lost(with_blue(lambda place: place % share == 0))["direction_right"] == "direction.blue-too"


def test_a_node_that_follows_the_blue_ball_alone_has_exchanged_them() -> None:
    assert lost(with_blue(lambda place: True))["direction_right"] == "direction.blue-ball"
    in_bgr = with_blue(lambda place: SHOWN.views[place].encoding == "bgr8")
    assert lost(in_bgr)["bgr_right"] == "direction.blue-ball"


def test_without_stamps_directions_are_not_judged() -> None:
    found = lost([(at, -1, vector) for at, _, vector in right_ones()])
    assert found.pop("stamps_kept") == "stamps-kept.no-stamp"
    assert {"direction_right", "bgr_right", "no_ball_said", "keeps_up"} <= set(found)
    assert set(found.values()) == {"skipped"}, found
