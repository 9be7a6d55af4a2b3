"""A simulated battery on recordings made by hand: full at first, then falling, with the word that fits its charge."""

import pytest
from std_msgs.msg import Float32, String

import workbook.criteria as see
from tests.criteria.by_hand import every, on_topic, recorded
from tests.criteria.test_vocabulary import accepts, refuses
from workbook.criteria import topic
from workbook.recording.recording import Clock, Recording

BATTERY = topic("/robot/battery", Float32, hz=0.5)
STATUS = topic("/robot/status", String, hz=1.0)
WORKS, EMPTY = "operational", "error"


def battery(levels: list[float], clock: Clock = "simulated") -> Recording:
    return recorded(on_topic(BATTERY.name, BATTERY.type, every(2.0, len(levels)), levels), clock=clock)


def both(levels: list[float], words: list[str]) -> Recording:
    """Record charges at 2, 4, 6, ... s, and words at 1, 2, 3, ... s, shortly after the charges."""
    return recorded(
        on_topic(BATTERY.name, BATTERY.type, every(2.0, len(levels)), levels),
        on_topic(STATUS.name, STATUS.type, [t + 0.01 for t in every(1.0, len(words))], words),
        clock="simulated",
    )


@pytest.mark.parametrize(
    "levels", [[100.0, 90.0], [91.0, 83.0, 75.5], [100.0, 100.0, 99.0], [99.2, 98.0, 97.5], [100.0]]
)
def test_a_battery_begins_full(levels: list[float]) -> None:
    accepts(see.begins_full(battery(levels), BATTERY))


def test_a_battery_that_begins_with_less_is_not_full() -> None:
    refuses(see.begins_full(battery([90.0, 89.0, 88.0]), BATTERY), "90 % in the first", "100.0")
    refuses(see.begins_full(battery([0.99, 0.98, 0.97]), BATTERY), "0.99 %", "fraction")


def test_on_the_wall_clock_the_first_messages_may_have_been_missed() -> None:
    assert see.begins_full(battery([75.0, 66.0, 57.0], "wall"), BATTERY).ok
    assert not see.begins_full(battery([75.0, 66.0, 57.0]), BATTERY).ok


def test_a_battery_drains() -> None:
    accepts(see.drains(battery([9.0, 4.0, 0.0, 0.0]), BATTERY), "drains")
    accepts(see.drains(battery([100.0, 100.0, 99.0]), BATTERY), "drains")
    refuses(see.drains(battery([100.0] * 4), BATTERY), "never changed")
    refuses(
        see.drains(battery([100.0, 90.0, 80.0, *[70.0] * 7]), BATTERY),
        "70 % halfway through and 70 % at the end",
        "stops falling",
    )


@pytest.mark.parametrize("change", [3, 5, 7])
def test_the_word_may_change_with_the_last_charge_or_with_the_first_zeros(change: int) -> None:
    words = [WORKS if place < change else EMPTY for place in range(12)]
    accepts(see.word_fits_charge(both([90.0, 40.0, 0.0, 0.0, 0.0], words), STATUS, BATTERY), "empty")


@pytest.mark.parametrize(
    ("words", "cause"),
    [
        ([EMPTY] * 5 + [WORKS] * 7, "word-fits-charge.turned-around"),
        ([WORKS] * 2 + [EMPTY] * 10, "word-fits-charge.too-early"),
        ([WORKS, EMPTY, WORKS, *[EMPTY] * 9], "word-fits-charge.changes"),
        ([WORKS] * 12, "word-fits-charge.never-error"),
        ([*[WORKS] * 7, EMPTY, *[WORKS] * 4], "word-fits-charge.error-not-kept"),
        ([*[WORKS] * 9, *[EMPTY] * 3], "word-fits-charge.too-late"),
    ],
)
def test_a_word_that_does_not_fit_the_charge(words: list[str], cause: str) -> None:
    verdict = see.word_fits_charge(both([90.0, 40.0, 0.0, 0.0, 0.0], words), STATUS, BATTERY)
    refuses(verdict, BATTERY.name.rsplit("/", 1)[1])
    assert verdict.cause == cause


@pytest.mark.parametrize("levels", [[0.0] * 5, [50.0] * 5, [50.0, 60.0, 0.0], []])
def test_a_charge_that_is_wrong_itself_says_nothing_about_the_word(levels: list[float]) -> None:
    assert see.word_fits_charge(both(levels, [EMPTY] * 10), STATUS, BATTERY).ok
