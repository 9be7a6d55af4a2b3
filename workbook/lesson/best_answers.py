"""Save the best version of each answer as a file, and its points in the student's progress."""

from dataclasses import replace
from pathlib import Path

from workbook.exercise.answer_files import Saved, answers_folder, replace_answer, same_program
from workbook.exercise.judgement import Judgement
from workbook.feedback import wording
from workbook.lesson.last_recordings import keep_recording
from workbook.lesson.progress import changed_progress, load_progress

BEST = ".best"


class NothingJudged(LookupError):
    """Raised when no version has earned points yet, so there is no best version."""


def best_file(stem: str, folder: Path | None = None) -> Path:
    """Return the path for an answer's best version, whether or not the file exists."""
    return (folder or answers_folder()) / BEST / f"{stem}.py"


def best_text(stem: str, folder: Path | None = None) -> str | None:
    """Return the text of the best version, or None if no version has earned points yet."""
    try:
        return best_file(stem, folder).read_text(encoding="utf-8")
    except OSError:
        return None


def hands_in_another(stem: str, folder: Path | None = None) -> bool:
    """Return whether the file to hand in differs from the best version.

    Among versions with equal points, the latest one counts as the best.
    """
    best = best_text(stem, folder)
    if best is None:
        return False
    try:
        text = ((folder or answers_folder()) / f"{stem}.py").read_text(encoding="utf-8", errors="replace")
    except OSError:
        return True
    return not same_program(best, text)


def restore_best(stem: str, folder: Path | None = None) -> Saved:
    """Replace the file to hand in with the best version and keep a copy of the old file.

    Raise NothingJudged if there is no best version.
    """
    best = best_text(stem, folder)
    if best is None:
        raise NothingJudged(f"No version of {stem} has earned points yet, so there is none to restore.")
    return replace_answer(stem, best, folder)


class Check:
    """A check of an answer. It counts as one try, no matter how often the answer is judged.

    The last judgment counts, but it can't lower the points that the student already has.
    """

    def __init__(self, stem: str, text: str) -> None:
        self._stem = stem
        self._text = text
        self.before = load_progress(stem)
        self._best_before = best_text(stem)
        self._left = (self.before.solved, self.before.best, self._best_before)
        self._noted = False

    def note(self, judgement: Judgement) -> None:
        """Save a judgment. A later judgment of the same check replaces it."""
        keep_recording(judgement)
        if judgement.status != "graded":
            return
        points = wording.shown_points(judgement)[0]
        with changed_progress(self._stem) as progress:
            if (progress.solved, progress.best, best_text(self._stem)) != self._left:
                # another notebook or a terminal has judged this exercise since this check began
                self.before, self._best_before = replace(progress), best_text(self._stem)
            progress.tries += not self._noted
            progress.solved = self.before.solved or wording.all_shown_hold(judgement)
            progress.best = max(self.before.best, points)
            self._keep(self._text if 0 < points >= self.before.best else self._best_before)
            self._left = (progress.solved, progress.best, best_text(self._stem))
        self._noted = True

    def best_of_another_version(self) -> float | None:
        """Return the best version's points if this check judged a different version, or None otherwise."""
        best = best_text(self._stem)
        if best is None or same_program(best, self._text):
            return None
        return load_progress(self._stem).best

    def _keep(self, best: str | None) -> None:
        file = best_file(self._stem)
        if best is None:
            file.unlink(missing_ok=True)
        elif best != best_text(self._stem):
            file.parent.mkdir(parents=True, exist_ok=True)
            partial = file.with_suffix(".part")
            partial.write_text(best, encoding="utf-8")
            partial.replace(file)
