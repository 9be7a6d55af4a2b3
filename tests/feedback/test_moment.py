"""What a card shows in addition when an answer gets full marks."""

import io
from dataclasses import replace
from pathlib import Path

import pytest
from PIL import Image

from workbook.feedback.moment import POSES, film_of, gained, still_of, what_comes_next
from workbook.recording.recording import Recording

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
LARGEST_BYTES = 300_000


@pytest.fixture(scope="module")
def recording() -> Recording:
    return Recording.load(ROOT / "tests" / "recordings" / STEM / "solution.json")


def frames(film: bytes) -> list[bytes]:
    picture = Image.open(io.BytesIO(film))
    assert picture.format == "WEBP"
    assert picture.info["loop"] == 1, "a film that plays forever disturbs who reads"
    found = []
    for number in range(getattr(picture, "n_frames", 1)):
        picture.seek(number)
        found.append(picture.convert("RGBA").tobytes())
    return found


def test_the_robot_moves_as_the_program_said(recording: Recording) -> None:
    film = film_of(recording)
    assert film.text == f"Your robot moves through the first {POSES} poses that your program sent."
    assert len(set(frames(film.moving))) > 10
    assert len(film.moving) < LARGEST_BYTES
    topic = recording.topics["/robot/joint_positions"]
    other = replace(
        topic,
        arrivals=tuple(replace(one, value={"data": [0.5] * 12}) for one in topic.arrivals),
    )
    still = film_of(replace(recording, topics={**recording.topics, topic.name: other})).still
    assert still != film.still, "the last picture comes from the recording"
    assert still_of(recording).still == film.still and not still_of(recording).moving


@pytest.mark.parametrize("value", [{"data": [1.0] * 11}, {"data": ["NaN"] * 12}, {"data": 7}, None])
def test_the_robot_waves_where_there_is_no_pose(recording: Recording, value: object) -> None:
    topic = recording.topics["/robot/joint_positions"]
    other = replace(topic, arrivals=(replace(topic.arrivals[0], value=value),))
    film = film_of(replace(recording, topics={**recording.topics, topic.name: other}))
    assert film.text == still_of(replace(recording, topics={topic.name: other})).text == "The robot waves."
    assert len(set(frames(film.moving))) > 10


@pytest.mark.parametrize(
    ("before", "now", "said"),
    [
        (0.0, 10.0, "You gained 10 points."),
        (8.0, 10.0, "2 more points than before."),
        (10.0, 10.0, "already had these points"),
    ],
)
def test_the_points_gained(before: float, now: float, said: str) -> None:
    assert said in gained(before, now, 3, 14)
    assert "3 of 14 exercises solved." in gained(before, now, 3, 14)


def test_what_comes_next_is_a_lesson_that_exists() -> None:
    lessons = sorted(path.stem for path in (ROOT / "notebooks").glob("[0-9]*.ipynb"))
    title, link = what_comes_next(ROOT, STEM)
    assert title.startswith("10")
    assert (ROOT / "exercises" / link).resolve().is_file()
    assert what_comes_next(ROOT, lessons[-1]) == ("", "")


def test_an_optional_notebook_is_not_what_comes_next() -> None:
    assert (ROOT / "notebooks" / "01_the_context_deeper.ipynb").is_file()
    assert what_comes_next(ROOT, "01_the_context")[0].startswith("02")
