"""The drawing of the machine: what it shows at a moment, which moments are chosen, and the film's size."""

import io

import pytest
from PIL import Image

from tests.pictures.reading import colored
from workbook.pictures import machine
from workbook.pictures.machine_film import MOST, STEPS, moments, play
from workbook.pictures.palette import AMBER, BLUE, GREEN, RED
from workbook.recording.machine import Call, Item, MachineRecording, Source, Wait

MOST_BYTES = 400_000
DISTANCE = Source("subscription", "/robot/distance", "on_distance", 2, None, 0)
BLINK = Source("timer", "timer, 0.2 s", "blink", 1, 0.2, 0)


def recording(messages: int = 4) -> MachineRecording:
    """Record messages every 0.2 s. The node isn't spun for a second; then each callback takes 0.5 s."""
    came = [0.2 * n for n in range(1, messages + 1)]
    items = [
        Item(0, n, t, None, came[n + 1])
        if n + 1 < len(came)
        else Item(0, n, t, 1.0 + 0.5 * (n - len(came) + 1))
        for n, t in enumerate(came, start=1)
    ]
    taken = [(one.number, one.taken) for one in items if one.taken is not None]
    calls = [Call(0, number, 1, begin, begin + 0.5) for number, begin in taken]
    ticks = [Item(1, 1, 1.2, None), Item(1, 2, 1.4, None, 1.4)]
    return MachineRecording(
        [DISTANCE, BLINK], [*items, *ticks], calls, [Wait(1.0, 1.0, (0, 1))], [(1.0, 2.0)], 1, 2.0
    )


def drawn(now: float) -> bytes:
    return machine.draw(recording(), machine.Instant(now, "words"))


def test_the_drawing_has_the_colors_of_what_happens() -> None:
    before, losing, running, busy = drawn(0.1), drawn(0.61), drawn(1.01), drawn(1.3)
    counts = {
        color: [int(colored(png, color).sum()) for png in (before, losing, running, busy)]
        for color in (BLUE, RED, GREEN, AMBER)
    }
    assert counts[RED][0] == 0
    assert counts[RED][1] > 50
    assert counts[BLUE][1] > counts[BLUE][0]
    assert (counts[GREEN][0], counts[AMBER][0]) == (0, 0)
    assert counts[GREEN][2] > 100
    assert counts[AMBER][3] > 100


def test_each_arrival_and_each_callback_has_its_moment() -> None:
    told = [moment.words for moment in moments(recording(), 0.0, 2.0)]
    assert sum(words.startswith("Message") for words in told) == 4
    assert sum("calls on_distance" in words for words in told) == 2
    assert any("The queue is full: message 1 is thrown away" in words for words in told)
    assert any("one tick waits already" in words for words in told)
    assert told[0] == "No thread is in spin. New messages wait in their queues."


def test_a_part_of_the_recording_is_played() -> None:
    chosen = moments(recording(), 0.9, 1.5)
    assert chosen[0].t >= 0.9
    assert chosen[-1].t <= 1.5


def test_the_film_moves_and_fits_into_a_notebook() -> None:
    film = play(recording(), "messages wait until somebody spins")
    with Image.open(io.BytesIO(film.png)) as picture:
        assert getattr(picture, "n_frames", 1) > 8
    assert len(film.png) < MOST_BYTES


def test_a_long_recording_has_no_more_pictures_than_fit() -> None:
    assert len(moments(recording(200), 0.0, 60.0)) <= MOST


def test_those_who_want_no_motion_get_stills() -> None:
    bundle, metadata = play(recording(), "messages wait")._repr_mimebundle_()
    page = bundle["text/html"]
    assert bundle["text/plain"] == "Picture: messages wait"
    assert metadata["image/png"]["alt"] == "messages wait"
    assert "prefers-reduced-motion" in page
    assert "<details><summary>Step by step" in page
    width, height = metadata["image/png"]["width"], metadata["image/png"]["height"]
    assert f'height="{STEPS * height}"' in page
    assert page.count(f'width="{width}"') == 2


def test_a_recording_in_which_nothing_happened_is_refused() -> None:
    empty = MachineRecording([DISTANCE], [], [], [], [], 1, 0.1)
    with pytest.raises(ValueError, match="nothing happened"):
        play(empty, "nothing")
