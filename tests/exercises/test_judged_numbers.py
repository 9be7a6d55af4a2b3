"""The numbers in a task are the judge's: digits are filled in, and number words are compared."""

from pathlib import Path

import pytest

from workbook.authoring.task_text import folded, task_text
from workbook.criteria.vocabulary import batteries, rates
from workbook.exercise.course import course_folder
from workbook.exercise.definition import Exercise, load_exercise
from workbook.exercise.judged_numbers import with_judged_numbers
from workbook.exercise.source import SourceError, load

ROOT = course_folder()


def exercise(number: str) -> Exercise:
    """Load an exercise by its two digits."""
    return load_exercise(number, ROOT)


def task(number: str) -> str:
    """Return the text of a task as a student reads it, as one line."""
    return folded(task_text(exercise(number).source))


def written(tmp_path: Path, sentence: str) -> Path:
    """Return the source of exercise 05 with one more sentence in its task."""
    text = (ROOT / "solutions" / "05_timers.py").read_text(encoding="utf-8")
    path = tmp_path / "05_timers.py"
    path.write_text(text.replace("\n# %% [answer]", f"\n# {sentence}\n\n# %% [answer]", 1), encoding="utf-8")
    return path


class TestPlaceholders:
    @pytest.mark.parametrize(
        ("sentence", "told"),
        [
            ("Within {{LIMIT_S}} s.", "Within 0.25 s."),
            ("{{SHARE %}} or more.", "80 % or more."),
            ("At {{TIMES_S.1}} s.", "At 2 s."),
            ("To {{TINY}} rad.", "To 0.000001 rad."),
            ("Off by {{rates.RATE_TOLERANCE %}}.", f"Off by {100 * rates.RATE_TOLERANCE:.0f} %."),
            ("A dict is {1: {}}, and {{}} stays.", "A dict is {1: {}}, and {{}} stays."),
        ],
    )
    def test_a_number_of_the_judge_is_filled_in(self, tmp_path: Path, sentence: str, told: str) -> None:
        known = {"LIMIT_S": 0.25, "SHARE": 0.8, "TIMES_S": (1.0, 2.0), "TINY": 1e-6}
        filled = with_judged_numbers(load(written(tmp_path, sentence)), known)
        assert any(told in text for text in filled.story)

    @pytest.mark.parametrize("name", ["NOWHERE", "rates.NOWHERE", "nowhere.AT_ALL", "WORD", "TIMES_S.7"])
    def test_what_is_no_number_of_the_judge_is_refused_with_its_line(self, tmp_path: Path, name: str) -> None:
        path = written(tmp_path, f"Within {{{{{name}}}}} s.")
        [line] = [n for n, text in enumerate(path.read_text().splitlines(), start=1) if name in text]
        with pytest.raises(SourceError, match=rf"{line}.*{name}.* is no number of the judge's"):
            with_judged_numbers(load(path), {"WORD": "soon", "TIMES_S": (1.0,)})


@pytest.mark.parametrize(
    ("number", "constants", "words"),
    [
        ("04", {"SHARE_AT_ONCE": 0.9}, "one good reading in ten"),
        ("10", {"AVERAGED": 5}, "averaged over five consecutive intervals"),
        ("10", {"WATCH_S": 9.0}, "nine seconds of real time"),
        ("11", {"ALONE_SHARE": 0.75}, "three quarters of the touches that arrive alone"),
        ("12", {"WATCH_S": 12.5}, "twelve and a half seconds of real time"),
        ("12", {"PAUSES": 1}, "at most one may be longer"),
        ("13", {"WATCH_S": 15.0}, "for fifteen seconds of real time"),
        ("14", {"SHARE_AT_ONCE": 0.9}, "nine out of ten within 0.5 s"),
        ("14", {"PERIOD_S": 0.05}, "20 messages a second, with the names"),
        ("16", {"MOSTLY_SHARE": 0.9}, "nine out of ten within 0.35 s"),
        ("16", {"TILTED_SAMPLES": 10}, "ten samples in a row"),
    ],
)
def test_a_number_that_is_written_as_words(number: str, constants: dict[str, float], words: str) -> None:
    applied = exercise(number).constants
    assert {name: applied[name] for name in constants} == constants
    assert words in task(number)


def test_05_tells_what_evenly_means() -> None:
    assert "never more than one and a half" in task("05") and rates.LONGEST_GAP_PERIODS == 1.5


def test_08_tells_how_many_steps_below_full_the_first_charge_may_be() -> None:
    assert (batteries.DROPS_BEFORE_THE_FIRST, batteries.DROPS_MISSED_ON_THE_WALL_CLOCK) == (1.5, 4.0)
    told = task("08")
    assert "% plus 1.5 times the largest drop" in told and "% plus four times the largest drop" in told


@pytest.mark.parametrize("number", ["08", "09"])
def test_08_and_09_tell_how_far_a_rate_may_be_off(number: str) -> None:
    periods = exercise(number).periods
    assert periods
    for topic, period in periods.items():
        low, high = ((1 + sign * rates.RATE_TOLERANCE) / period for sign in (-1, 1))
        gap = f"no gap over {rates.LONGEST_GAP_PERIODS * period:g} s"
        assert f"({low:g} to {high:g} Hz, {gap}" in task(number), topic


def test_05_tells_how_long_it_watches() -> None:
    assert exercise("05").plan.simulated_s == 60.0
    assert "for one minute of simulated time" in task("05")
