"""Pages of the gradebook: one for each student, and one for the class. They need no network and no script."""

import hashlib
import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from workbook.exercise.definition import Exercise
from workbook.exercise.judgement import Judgement
from workbook.feedback.card import COLORS, Extras, as_html
from workbook.feedback.timeline import judged_timeline
from workbook.grading.exports import by_student
from workbook.grading.results import Result, criterion_result
from workbook.recording.recording import Recording
from workbook.templating import as_markup, render

PAGES = "pages"
CLASS = "class.html"
SLOWEST = 5
COMMON = 3


def page_name(student: str, exercise: str) -> str:
    """A file name that no two students share, whatever they are called."""
    plain = re.sub(r"[^A-Za-z0-9]+", "-", student).strip("-").lower()[:40]
    return (
        f"{exercise}-{plain}-{hashlib.sha256(student.encode('utf-8', 'surrogatepass')).hexdigest()[:8]}.html"
    )


def judgement_of(result: Result, out: Path) -> Judgement:
    """The judgement that a result tells of, with its stored recording where there is one."""
    recording = None
    if result.recording is not None:
        try:
            recording = Recording.load(out / result.recording)
        except (OSError, ValueError):
            recording = None
    return Judgement(
        stem=result.exercise,
        answer_sha256=result.answer_sha256,
        status="graded" if result.status == "graded" else "infra_error",
        reason=result.reason,
        criteria=tuple(map(criterion_result, result.criteria)),
        recording=recording,
        doubt=result.doubt,
    )


def student_page(result: Result, exercise: Exercise, out: Path) -> str:
    """One student's page: the card, when messages were expected and came, and the log."""
    judgement = judgement_of(result, out)
    timeline, words = None, ""
    if judgement.recording is not None and exercise.periods:
        timeline, words = judged_timeline(exercise, judgement.recording)
    return render(
        "grading/student",
        title=f"{exercise.source.title}: {result.student}",
        result=result,
        card=as_markup(as_html(judgement, Extras(timeline=timeline, timeline_text=words))),
    )


def class_page(results: Iterable[Result], exercise: Exercise) -> str:
    """How the class did: points, the criteria that fail most, common sights, the slowest, and who is not graded."""
    rows = by_student(results)
    graded = [row for row in rows if row.score is not None]
    return render(
        "grading/class",
        title=f"{exercise.source.title}: the class",
        colors=COLORS,
        page_name=page_name,
        rows=rows,
        graded=graded,
        mean=_mean(graded),
        isolation=_isolation(rows),
        distribution=_distribution(graded, round(exercise.max_points)),
        criteria=_losses(graded),
        common=_common(graded),
        slowest=_slowest(graded),
        twice=sorted((row for row in rows if row.tries), key=lambda row: row.tries_differ, reverse=True),
        missing=[row for row in rows if row.score is None],
    )


def _mean(graded: Sequence[Result]) -> str:
    scores = sorted(row.score for row in graded if row.score is not None)
    if not scores:
        return ""
    middle = (scores[(len(scores) - 1) // 2] + scores[len(scores) // 2]) / 2
    return f"Mean {sum(scores) / len(scores):.2g}, median {middle:g} points."


def _isolation(rows: Sequence[Result]) -> str:
    tiers = Counter(row.isolation for row in rows)
    told = ", ".join(f"{tier} ({count})" for tier, count in sorted(tiers.items()))
    return f"Isolation: {told}." if told else ""


def _distribution(graded: Sequence[Result], most: int) -> list[tuple[int, int, float]]:
    """For all points, rounded down, from the most to none: how many answers got them, as a share of the largest."""
    bins = Counter(min(most, int(row.score)) for row in graded if row.score is not None)
    largest = max(bins.values(), default=1)
    return [(points, bins[points], bins[points] / largest) for points in range(most, -1, -1)]


@dataclass(frozen=True)
class _Losses:
    """How many answers lost a criterion, and in how many it was not looked at."""

    title: str
    lost: int
    skipped: int


def _losses(graded: Sequence[Result]) -> list[_Losses]:
    titles: dict[str, str] = {}
    lost: Counter[str] = Counter()
    skipped: Counter[str] = Counter()
    for row in graded:
        for one in row.criteria:
            titles[one.id] = one.title
            lost[one.id] += one.is_lost
            skipped[one.id] += one.status == "skipped"
    return [
        _Losses(titles[name], count, skipped[name])
        for name, count in sorted(lost.items(), key=lambda item: -item[1])
    ]


def _common(graded: Sequence[Result]) -> list[tuple[str, str, int]]:
    """What was seen in more than one answer that lost a criterion: its title, the sight, and how often."""
    seen: dict[str, Counter[str]] = {}
    for row in graded:
        for one in row.criteria:
            if one.is_lost:
                seen.setdefault(one.title, Counter())[one.saw] += 1
    return [
        (title, saw, count)
        for title, sights in sorted(seen.items())
        for saw, count in sights.most_common(COMMON)
        if count > 1
    ]


def _slowest(graded: Sequence[Result]) -> list[Result]:
    return sorted((row for row in graded if row.wall_s is not None), key=lambda row: -(row.wall_s or 0.0))[
        :SLOWEST
    ]
