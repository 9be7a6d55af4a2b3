"""Define the wording of feedback, which is the same on a card, in a terminal, and on a page."""

from workbook.criteria.runner import CriterionResult
from workbook.exercise.course import NoCourse, course_folder
from workbook.exercise.judgement import Judgement
from workbook.exercise.museum import BrokenMuseum, Exhibit, load_museum

SIGNS = {"passed": "✓", "failed": "✗", "partial": "◐", "skipped": "–"}
SHORTEST_WATCH_S = 0.5
"""A watch that's shorter than this (s) would be reported as 0 s, so it gets a sentence instead."""
ENDED_TOO_SOON = "The program ended before there was anything to watch."
NOTHING_WATCHED = "There was nothing to watch."
WORDS = {"passed": "passes", "failed": "not yet", "partial": "in part", "skipped": "not judged"}


def points(value: float) -> str:
    """Return points without a trailing ".0"."""
    return f"{value:g}"


def earned(result: CriterionResult) -> str:
    """Return a criterion's points, such as "1 of 2", or "needed" if it's worth no points but has to pass first."""
    if not result.max_points:
        return "needed"
    return f"{points(result.points)} of {points(result.max_points)}"


def visible(judgement: Judgement) -> list[CriterionResult]:
    """Return the criteria that a student may read. Criteria worth no points are included unless they passed."""
    return [
        result
        for result in judgement.criteria
        if not result.hidden and (result.max_points > 0 or result.status != "passed")
    ]


def worst_first(judgement: Judgement) -> list[CriterionResult]:
    """Return the visible criteria: failed and partial ones first, then skipped ones, then passed ones."""
    order = ("failed", "partial"), ("skipped",), ("passed",)
    return [one for states in order for one in visible(judgement) if one.status in states]


def hidden_count(judgement: Judgement) -> int:
    """Return the number of hidden criteria, whose points count although students don't see them."""
    return sum(result.hidden for result in judgement.criteria)


def first_to_mend(judgement: Judgement) -> CriterionResult | None:
    """Return the first visible criterion that failed or passed in part, or None if there is none."""
    return next((one for one in visible(judgement) if one.status in ("failed", "partial")), None)


def exhibit_of(judgement: Judgement) -> Exhibit | None:
    """Return the error museum's entry for the first criterion to fix.

    The result is None if there is no such entry, or no museum.
    """
    first = first_to_mend(judgement)
    if first is None:
        return None
    try:
        museum = load_museum(course_folder())
    except (BrokenMuseum, NoCourse, OSError):
        return None
    return museum.exhibit_for(f"{first.saw}\n{first.because}")


def also_to_mend(judgement: Judgement) -> list[CriterionResult]:
    """Return the visible criteria that failed or passed only partially, except the first one."""
    return [one for one in visible(judgement) if one.status in ("failed", "partial")][1:]


def shown_points(judgement: Judgement) -> tuple[float, float]:
    """Return the points earned and the maximum, excluding hidden criteria, whose results the points would give away."""
    shown = [result for result in judgement.criteria if not result.hidden]
    return round(sum(result.points for result in shown), 6), sum(result.max_points for result in shown)


def all_shown_hold(judgement: Judgement) -> bool:
    """Return whether every visible criterion passed."""
    shown = [result for result in judgement.criteria if not result.hidden]
    return judgement.status == "graded" and all(result.status == "passed" for result in shown)


def headline(judgement: Judgement) -> str:
    """Return a one-line summary. It doesn't contain times, so it's the same in every run with the same result."""
    if judgement.status != "graded":
        return f"Not judged: {judgement.reason}"
    score, most = map(points, shown_points(judgement))
    if all_shown_hold(judgement):
        return f"Full marks: {score} of {most} points."
    return f"{score} of {most} points."


def printed(judgement: Judgement) -> str:
    """Return the program's entire output, or "" if there is no recording."""
    recording = judgement.recording
    return "" if recording is None else recording.process.log + recording.process.end_log


def clock_line(judgement: Judgement) -> str:
    """Return a line that says which clock the judgment used and how long the watch took."""
    recording = judgement.recording
    if recording is None:
        return ""
    if recording.watched_s < SHORTEST_WATCH_S:
        return ENDED_TOO_SOON if recording.process.ended_by == "itself" else NOTHING_WATCHED
    if recording.clock == "simulated":
        line = f"The judge watched {recording.watched_s:.0f} s of robot time, which took {recording.wall_s:.1f} s."
        if judgement.watched_real_life:
            seconds = recording.process.watched_for
            line += f" Then it started the program again, and watched it for {seconds:.0f} s in real time."
        return line
    return f"The judge watched the program for {recording.watched_s:.0f} s in real time."


def provisional_line(judgement: Judgement) -> str:
    """Return a line that says why this judgment may still change, or "" for a final judgment."""
    if not judgement.provisional:
        return ""
    if judgement.inconclusive_reason:
        return (
            f"Inconclusive: {judgement.inconclusive_reason}. Your program is judged once more, which takes a few "
            "seconds."
        )
    return "Provisional: this was judged on fast robot time. The run on the wall clock decides; it takes a few seconds."


def inconclusive_line(judgement: Judgement, *, is_graded: bool = False) -> str:
    """Return a line that says why the judgment is inconclusive, or "" for a conclusive one.

    `is_graded`: whether the judgment belongs to a gradebook, so that no other try follows.
    """
    if not judgement.inconclusive_reason or judgement.provisional:
        return ""
    then = "." if is_graded else "; another try decides."
    return f"Inconclusive: {judgement.inconclusive_reason}. This may not be the program's fault{then}"


def hidden_line(judgement: Judgement) -> str:
    """Return a sentence that states the number of hidden criteria, or "" if there are none."""
    count = hidden_count(judgement)
    if not count:
        return ""
    what = "one more criterion" if count == 1 else f"{count} more criteria"
    return f"The instructor judges {what} that this check does not show."
