"""Show a check's card in the cell. Each later judgment replaces the card of the previous one.

Before the first judgment, a line shows what the judge is watching, and its progress. In JupyterLab, a robot moves next
to that line.
"""

import threading
import time
from contextlib import suppress
from importlib import import_module
from typing import TYPE_CHECKING

from IPython.display import DisplayHandle, display

from workbook.exercise.definition import Exercise
from workbook.exercise.judgement import Judgement
from workbook.feedback.card import Card
from workbook.feedback.moment import Film, film_of, still_of
from workbook.grading.slots.protocol import Progress
from workbook.magics import checking
from workbook.magics.checking import Asked
from workbook.templating import render

if TYPE_CHECKING:
    from workbook.magics.robot_on_card import WatchedRobot

ROBOT_ON_CARD = "workbook.magics.robot_on_card"
CHECK = "application/vnd.rclpy-workbook.check+json"
"""MIME type of the instructions to card.js that move the robot on a card."""
BLANK_S = 0.3
"""The longest time (s) for which the cell's output may stay empty."""
ROBOT_AFTER_S = ROBOT_FOR_S = 1.0
"""The robot appears only after this time (s), and only if it will stay for at least as long. Otherwise, it would just
flash.
"""
_MINUTE = (55, 65)


class WaitingLine:
    """The output before there's a card: what the judge watches, and its progress."""

    def __init__(
        self, exercise: Exercise, progress: Progress | None = None, *, has_robot: bool = False
    ) -> None:
        self._text = _what_is_watched(exercise)
        self._has_robot = has_robot
        self._counters: list[str] = []
        if progress is not None:
            self._counters = [f"{progress.watched_s:.1f} s so far", *progress.counters()]
            if progress.place:
                self._text, self._counters = f"Waiting to judge your program: {progress}", []

    def __repr__(self) -> str:
        return f"{self._text} {', '.join(self._counters)}".rstrip()

    def _repr_html_(self) -> str:
        return render("magics/waiting", text=self._text, counters=self._counters, has_robot=self._has_robot)


def _what_is_watched(exercise: Exercise) -> str:
    """Return a sentence that gives the duration of the watch, in simulated or real time, as the exercise requires."""
    seconds = round(_planned_s(exercise))
    shortest, longest = _MINUTE
    how_long = "one minute" if shortest <= seconds <= longest else f"{seconds} seconds"
    how = "in fast motion" if exercise.source.clock == "simulated" else "in real time"
    return f"Watching {how_long} of your robot's life, {how} ..."


def _planned_s(exercise: Exercise) -> float:
    return exercise.plan.simulated_s if exercise.source.clock == "simulated" else exercise.plan.wall_s


class LiveCard:
    """The card of a check. Its `judge` runs in a thread, so the output never waits for the front end.

    `decided` is set once a final card is shown, or if there can't be one. `judgement` is the final judgment.
    `superseded` is set if a newer check is waiting, so that an inconclusive judgment isn't repeated. `abandoned` is set
    if nothing more should be shown.
    """

    def __init__(self, asked: Asked) -> None:
        self.decided = threading.Event()
        self.superseded = threading.Event()
        self.abandoned = threading.Event()
        self.judgement: Judgement | None = None
        self._asked = asked
        self._handle: DisplayHandle | None = None
        self._film: Film | None = None
        self._replay: dict[str, object] = {}
        self._robot: WatchedRobot | None = None
        self._began = time.monotonic()
        self._one_at_a_time = threading.Lock()
        self._has_card = False

    def judge(self) -> None:
        """Judge the answer and show the result."""
        asked = self._asked
        blank = threading.Timer(BLANK_S, self._begin_to_wait)
        blank.daemon = True
        blank.start()
        try:
            stem, stop = asked.exercise.stem, self.superseded.is_set
            self._show(checking.judge(stem, asked.answer, self._show, stop, self._wait))
        finally:
            blank.cancel()
            self.decided.set()

    def _begin_to_wait(self) -> None:
        self._wait(None)
        if self._asked.replays:
            import_module(ROBOT_ON_CARD)  # imported only now, so that the import doesn't delay anything else

    def _wait(self, progress: Progress | None) -> None:
        """Show progress until the card is ready.

        The output stays empty for the first `BLANK_S` seconds, because most checks finish within that time.
        """
        with self._one_at_a_time:
            is_early = progress is not None and self._handle is None
            if not (self._has_card or self.abandoned.is_set() or is_early):
                self._put_waiting_line(progress)

    def _put_waiting_line(self, progress: Progress | None) -> None:
        robot = None if progress is None else self._watched(progress)
        self._put(WaitingLine(self._asked.exercise, progress, has_robot=robot is not None), robot)

    def _watched(self, progress: Progress) -> dict[str, object] | None:
        now = time.monotonic()
        passed = now - self._began
        if not self._asked.replays or passed < ROBOT_AFTER_S:
            return None
        if self._robot is None:
            left = _planned_s(self._asked.exercise) - progress.watched_s
            if 0 <= left * passed < ROBOT_FOR_S * progress.watched_s:
                return None
            from workbook.magics.robot_on_card import WatchedRobot

            self._robot = WatchedRobot()
        return self._robot.after(progress, now)

    def _show(self, judgement: Judgement) -> None:
        if self.abandoned.is_set():
            return
        if not judgement.provisional:
            self.judgement = judgement
            with suppress(OSError):  # if the disk is full, only the saved progress is lost
                self._asked.kept.note(judgement)
        with self._one_at_a_time:
            self._has_card = True
            self._put_card(judgement)
        if judgement.provisional:
            return
        self.decided.set()
        if self._film is None and checking.deserves_praise(self._asked, judgement):
            self._add_the_robot(judgement)

    def _put_card(self, judgement: Judgement) -> None:
        moves = self._asked.replays and checking.deserves_praise(self._asked, judgement)
        self._put(checking.card_for(self._asked, judgement, self._film), self._replay if moves else None)

    def _add_the_robot(self, judgement: Judgement) -> None:
        """Add the moving robot once the card is shown, because drawing even one frame takes half a second."""
        if judgement.recording is None:
            return
        try:
            if self._asked.replays:
                from workbook.magics.robot_on_card import replay_of

                self._replay = {"replay": replay_of(judgement.recording)}
                self._put_card(judgement)
            self._film = (still_of if self._asked.replays else film_of)(judgement.recording)
        except Exception:
            return  # a failed drawing must not lose the judgment
        self._put_card(judgement)

    def _put(self, shown: Card | WaitingLine, robot: dict[str, object] | None) -> None:
        """Show a card or a line. `robot`: instructions for card.js, or None without a robot."""
        bundle: dict[str, object] = {"text/plain": repr(shown), "text/html": shown._repr_html_()}
        if robot is not None:
            bundle[CHECK] = robot
        if self._handle is None:
            self._handle = display(bundle, raw=True, display_id=True)
        else:
            self._handle.update(bundle, raw=True)
