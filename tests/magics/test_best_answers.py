"""A solved exercise stays solved: the best judged version counts, and its file is kept."""

import subprocess
import sys
import threading
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement, judge_recording
from workbook.feedback.moment import Film
from workbook.grading.slots.client import ShowProgress
from workbook.grading.slots.protocol import Progress
from workbook.lesson.best_answers import (
    Check,
    NothingJudged,
    best_text,
    hands_in_another,
    restore_best,
)
from workbook.lesson.progress import load_progress
from workbook.magics import checking, live_card
from workbook.magics.checking import Asked
from workbook.recording.recording import Recording

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
EXERCISE = load_exercise(STEM, ROOT)


def judged(name: str) -> Judgement:
    recording = Recording.load(ROOT / "tests" / "recordings" / STEM / f"{name}.json")
    return judge_recording(EXERCISE, "0" * 64, recording)


FULL, EIGHT, NOTHING = judged("solution"), judged("period_for_frequency"), judged("raises_at_once")


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("WORKBOOK_ANSWERS", str(tmp_path))
    return tmp_path


def check(folder: Path, text: str, *judgements: Judgement) -> Check:
    (folder / f"{STEM}.py").write_text(text)
    one = Check(STEM, text)
    for judgement in judgements:
        one.note(judgement)
    return one


def test_a_later_wrong_try_changes_nothing(folder: Path) -> None:
    check(folder, "robot = 'right'\n", FULL)
    worse = check(folder, "robot = 'wrong'\n", EIGHT)
    progress = load_progress(STEM)
    assert (progress.tries, progress.solved, progress.best) == (2, True, 10.0)
    assert best_text(STEM) == "robot = 'right'\n"
    assert worse.best_of_another_version() == 10.0
    assert hands_in_another(STEM)


def test_what_was_judged_meanwhile_is_not_lowered_by_a_check_that_ends_later(folder: Path) -> None:
    """A check is still running when a better version is judged in a terminal."""
    slow = check(folder, "robot = 'eight'\n", EIGHT)
    check(folder, "robot = 'right'\n", FULL)
    slow.note(EIGHT)
    progress = load_progress(STEM)
    assert (progress.tries, progress.solved, progress.best) == (2, True, 10.0)
    assert best_text(STEM) == "robot = 'right'\n"


def test_the_last_word_of_a_check_counts_and_is_one_try(folder: Path) -> None:
    """The card first shows full marks on simulated time, but then the program ends too early in real time."""
    check(folder, "robot = 'ends early'\n", FULL, EIGHT)
    progress = load_progress(STEM)
    assert (progress.tries, progress.solved, progress.best) == (1, False, 8.0)
    check(folder, "robot = 'right'\n", FULL, FULL)
    check(folder, "robot = 'ends early'\n", FULL, EIGHT)
    progress = load_progress(STEM)
    assert (progress.tries, progress.solved, progress.best) == (3, True, 10.0)
    assert best_text(STEM) == "robot = 'right'\n"


def test_of_equally_good_versions_the_last_one_is_the_best(folder: Path) -> None:
    check(folder, "robot = 'right'\n", FULL)
    later = check(folder, "robot = 'right, and tidy'\n", FULL)
    assert best_text(STEM) == "robot = 'right, and tidy'\n"
    assert later.best_of_another_version() is None
    assert not hands_in_another(STEM)


def test_what_earned_nothing_or_was_not_judged_is_no_best_version(folder: Path) -> None:
    assert NOTHING.score == 0
    check(folder, "robot = 'broken'\n", NOTHING)
    check(folder, "robot = 'right'\n", replace(FULL, status="infra_error"))
    assert best_text(STEM) is None
    assert load_progress(STEM).tries == 1
    assert not hands_in_another(STEM)
    with pytest.raises(NothingJudged, match=STEM):
        restore_best(STEM)


def test_the_command_puts_the_best_version_back(folder: Path) -> None:
    check(folder, "robot = 'right'\n", FULL)
    check(folder, "robot = 'wrong'\n", EIGHT)
    command = [str(Path(sys.executable).with_name("workbook")), "restore", "9"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert "is your best version again" in done.stdout
    assert (folder / f"{STEM}.py").read_text() == "robot = 'right'\n"
    [before] = (folder / ".previous").glob("*.py")
    assert before.read_text() == "robot = 'wrong'\n"
    assert "already" in subprocess.run(command, capture_output=True, text=True, check=True).stdout


Bundle = Mapping[str, Any]


def put_on_screen(monkeypatch: pytest.MonkeyPatch, put: Callable[[Bundle], None]) -> None:
    """Call `put` with each version of the card, in place of IPython's `display` and its handle."""

    class Handle:
        def update(self, bundle: Bundle, raw: bool) -> None:
            put(bundle)

    def display(bundle: Bundle, raw: bool, display_id: bool) -> Handle:
        put(bundle)
        return Handle()

    monkeypatch.setattr(live_card, "display", display)


@pytest.mark.parametrize("can_draw", [True, False])
def test_the_card_comes_first_and_the_moving_robot_costs_no_judgement(
    folder: Path, monkeypatch: pytest.MonkeyPatch, can_draw: bool
) -> None:
    shown: list[str] = []
    card = live_card.LiveCard(
        Asked(EXERCISE, Answer("x\n"), folder / f"{STEM}.py", 3, None, check(folder, "x\n"))
    )

    def judge(_: str, __: Answer, report: Callable[[Judgement], None], *___: object) -> Judgement:
        report(FULL)
        return EIGHT

    def draw(_: Recording) -> object:
        assert len(shown) == 1 and card.decided.is_set()
        if not can_draw:
            raise OSError("encoder webp not available")
        return Film(b"film", b"still", "Your robot moves.")

    monkeypatch.setattr(checking, "judge", judge)
    monkeypatch.setattr(live_card, "film_of", draw)
    put_on_screen(monkeypatch, lambda bundle: shown.append(bundle["text/html"]))
    card.judge()
    assert ["Your robot moves." in page for page in shown] == (
        [False, True, False] if can_draw else [False, False]
    )
    assert "8 of 10 points" in shown[-1]
    assert load_progress(STEM).best == 8.0


def test_a_line_says_what_is_watched_until_the_card_comes(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shown: list[str] = []
    is_blank = threading.Event()
    card = live_card.LiveCard(
        Asked(EXERCISE, Answer("x\n"), folder / f"{STEM}.py", 3, None, check(folder, "x\n"))
    )

    def put(bundle: Bundle) -> None:
        assert live_card.CHECK not in bundle, "a front end that draws no robot gets none"
        shown.append(bundle["text/plain"])
        is_blank.set()

    def judge(
        _: str, __: Answer, report: Callable[[Judgement], None], ___: object, progress: ShowProgress
    ) -> Judgement:
        assert is_blank.wait(60)  # no message has come for a while
        progress(Progress(0, 12.0, {"/robot/joint_positions": 6}))
        report(EIGHT)
        progress(Progress(0, 13.0, {}))
        return EIGHT

    monkeypatch.setattr(checking, "judge", judge)
    put_on_screen(monkeypatch, put)
    card.judge()
    watching = "Watching 26 seconds of your robot's life, in fast motion ..."
    assert shown[:2] == [watching, f"{watching} 12.0 s so far, 6 on /robot/joint_positions"]
    assert all("8 of 10 points" in words for words in shown[2:]) and len(shown) == 4


def test_a_robot_moves_only_for_a_check_that_takes_long(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    robots: list[Any] = []
    now = [100.0]
    monkeypatch.setattr(live_card, "time", SimpleNamespace(monotonic=lambda: now[0]))
    monkeypatch.setattr(live_card, "BLANK_S", 3600.0)
    card = live_card.LiveCard(
        Asked(EXERCISE, Answer("x\n"), folder / f"{STEM}.py", 3, None, check(folder, "x\n"), replays=True)
    )
    put_on_screen(monkeypatch, lambda bundle: robots.append(bundle.get(live_card.CHECK)))

    def judge(
        _: str, __: Answer, report: Callable[[Judgement], None], ___: object, progress: ShowProgress
    ) -> Judgement:
        heard = Progress(0, 12.0, {"/robot/status": 6}, {"/robot/status": {"data": "operational"}})
        heard = replace(heard, types={"/robot/status": "std_msgs/msg/String"})
        card._wait(None)
        now[0] += live_card.ROBOT_AFTER_S - 0.1
        progress(heard)
        now[0] += 0.2
        progress(replace(heard, watched_s=25.9))  # almost all of the time has passed
        progress(heard)
        return FULL

    monkeypatch.setattr(checking, "judge", judge)
    card.judge()
    before, early, nearly_over, watched, *cards = robots
    assert before is None and early is None and nearly_over is None
    assert watched["news"]["face"] == "operational"
    assert [set(one) for one in cards] == [set(), {"replay"}, {"replay"}]
