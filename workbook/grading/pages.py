"""Pages of the gradebook: one for each student, and one for the class. They need no network and no script."""

import hashlib
import re
from collections import Counter
from collections.abc import Iterable, Sequence
from html import escape
from pathlib import Path

from workbook.exercise.definition import Exercise
from workbook.exercise.exchange import criteria_from_json
from workbook.exercise.judging import Judgement
from workbook.feedback.card import COLORS, Extras, as_html
from workbook.feedback.timeline import judged_timeline
from workbook.grading.exports import by_student
from workbook.grading.results import Result, tried_twice, tries_differ
from workbook.observing.recording import Recording

PAGES = "pages"
CLASS = "class.html"
SLOWEST = 5
COMMON = 3
_STYLE = (
    "body{font-family:system-ui,sans-serif;max-width:62rem;margin:2rem auto;padding:0 1rem;line-height:1.5;"
    "color-scheme:light dark}"
    "table{border-collapse:collapse}td,th{text-align:left;padding:3px 14px 3px 0;vertical-align:top}"
    "pre{white-space:pre-wrap;overflow-wrap:anywhere}img{max-width:100%}"
)


def _page(title: str, body: str) -> str:
    policy = "default-src 'none'; img-src data:; style-src 'unsafe-inline'"
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">'
        '<meta name="viewport" content="width=device-width">'
        f"<title>{escape(title)}</title><style>{_STYLE}</style></head>\n<body><h1>{escape(title)}</h1>\n"
        f"{body}\n</body></html>\n"
    )


def page_name(student: str, exercise: str) -> str:
    """A file name that no two students share, whatever they are called."""
    plain = re.sub(r"[^A-Za-z0-9]+", "-", student).strip("-").lower()[:40]
    return (
        f"{exercise}-{plain}-{hashlib.sha256(student.encode('utf-8', 'surrogatepass')).hexdigest()[:8]}.html"
    )


def judgement_of(result: Result, out: Path) -> Judgement:
    """The judgement that a result tells of, with its stored recording where there is one."""
    recording = None
    if result["recording"] is not None:
        try:
            recording = Recording.load(out / result["recording"])
        except (OSError, ValueError):
            recording = None
    return Judgement(
        stem=result["exercise"],
        answer_sha256=result["answer_sha256"],
        status="graded" if result["status"] == "graded" else "infra_error",
        reason=result["reason"],
        criteria=criteria_from_json(result["criteria"]),
        recording=recording,
        doubt=result.get("doubt") or "",
    )


def student_page(result: Result, exercise: Exercise, out: Path) -> str:
    """One student's page: the card, when messages were expected and came, and the log."""
    judgement = judgement_of(result, out)
    timeline, words = None, ""
    if judgement.recording is not None and exercise.periods:
        timeline, words = judged_timeline(exercise, judgement.recording)
    facts = [f"Answer: <code>{escape(result['answer'])}</code>", f"attempt {result['attempt']}"]
    facts.append(f"isolation: {escape(result['isolation'])}")
    if result["submitted_at"]:
        facts.append(f"handed in {escape(result['submitted_at'])}")
    if result.get("late_points"):
        facts.append(f"{result['late_points']:g} points taken off for handing in late")
    body = f"<p>{', '.join(facts)}.</p>"
    if twice := tried_twice(result):
        body += f"<p>{escape(twice)}</p>"
    body += as_html(judgement, Extras(timeline=timeline, timeline_text=words))
    return _page(f"{exercise.source.title}: {result['student']}", body)


def class_page(results: Iterable[Result], exercise: Exercise) -> str:
    """How the class did: points, the criteria that fail most, common sights, the slowest, and who is not graded."""
    rows = by_student(results)
    graded = [row for row in rows if row["score"] is not None]
    parts = [f"<p>{len(rows)} answers, {len(graded)} graded.{_mean(graded)}{_isolation(rows)}</p>"]
    parts += [_distribution(graded, exercise), _criteria(graded), _common(graded), _slowest(graded)]
    parts.append(_twice(rows))
    missing = [row for row in rows if row["score"] is None]
    if missing:
        lines = "".join(
            f"<tr><td>{_name_of(row)}</td><td>{escape(row['status'])}</td>"
            f"<td>{escape(str(row['reason']))}</td></tr>"
            for row in missing
        )
        parts.append(f"<h2>Not graded</h2><table>{lines}</table>")
    links = "".join(
        f'<tr><td><a href="{_page_of(row)}">{_name_of(row)}</a></td><td>{_points(row)}</td></tr>'
        for row in rows
    )
    parts.append(f"<h2>Everybody</h2><table><tr><th>student</th><th>points</th></tr>{links}</table>")
    return _page(f"{exercise.source.title}: the class", "\n".join(parts))


def _mean(graded: Sequence[Result]) -> str:
    if not graded:
        return ""
    scores = sorted(row["score"] for row in graded)
    middle = (scores[(len(scores) - 1) // 2] + scores[len(scores) // 2]) / 2
    return f" Mean {sum(scores) / len(scores):.2g}, median {middle:g} points."


def _isolation(rows: Sequence[Result]) -> str:
    tiers = Counter(str(row["isolation"]) for row in rows)
    if not tiers:
        return ""
    told = ", ".join(f"{escape(tier)} ({count})" for tier, count in sorted(tiers.items()))
    return f" Isolation: {told}."


def _page_of(row: Result) -> str:
    return escape(page_name(row["student"], row["exercise"]))


def _name_of(row: Result) -> str:
    return escape(row["student"])


def _points(row: Result) -> str:
    return "–" if row["score"] is None else f"{row['score']:g}"


def _bar(share: float, color: str) -> str:
    if not share:
        return ""
    width = max(0.2, 16 * share)
    return f'<span style="display:inline-block;height:0.8em;width:{width:.1f}em;background:{color}"></span>'


def _distribution(graded: Sequence[Result], exercise: Exercise) -> str:
    most = round(exercise.max_points)
    bins = Counter(min(most, int(row["score"])) for row in graded)
    largest = max(bins.values(), default=1)
    lines = "".join(
        f"<tr><td>{points}</td><td>{_bar(bins[points] / largest, COLORS['passed'])} {bins[points]}</td></tr>"
        for points in range(most, -1, -1)
    )
    return f"<h2>Points</h2><table><tr><th>points, rounded down</th><th>answers</th></tr>{lines}</table>"


def _criteria(graded: Sequence[Result]) -> str:
    titles: dict[str, str] = {}
    lost: Counter[str] = Counter()
    skipped: Counter[str] = Counter()
    for row in graded:
        for one in row["criteria"]:
            titles[one["id"]] = one["title"]
            lost[one["id"]] += one["status"] in ("failed", "partial")
            skipped[one["id"]] += one["status"] == "skipped"
    lines = "".join(
        f"<tr><td>{escape(titles[name])}</td><td>{_bar(count / len(graded), COLORS['failed'])} {count}</td>"
        f"<td>{skipped[name]}</td></tr>"
        for name, count in sorted(lost.items(), key=lambda item: -item[1])
    )
    head = "<tr><th>criterion</th><th>does not hold</th><th>not looked at</th></tr>"
    return f"<h2>What fails most</h2><table>{head}{lines}</table>"


def _common(graded: Sequence[Result]) -> str:
    seen: dict[str, Counter[str]] = {}
    for row in graded:
        for one in row["criteria"]:
            if one["status"] in ("failed", "partial"):
                seen.setdefault(one["title"], Counter())[one["saw"]] += 1
    lines = "".join(
        f"<tr><td>{escape(title)}</td><td>{escape(saw)}</td><td>{count} ×</td></tr>"
        for title, sights in sorted(seen.items())
        for saw, count in sights.most_common(COMMON)
        if count > 1
    )
    return f"<h2>Seen more than once</h2><table>{lines}</table>" if lines else ""


def _twice(rows: Sequence[Result]) -> str:
    twice = [row for row in rows if row.get("tries")]
    lines = "".join(
        f'<tr><td><a href="{_page_of(row)}">{_name_of(row)}</a></td>'
        f"<td>{'<b>differ</b>' if tries_differ(row) else 'agree'}</td><td>{escape(tried_twice(row))}</td></tr>"
        for row in sorted(twice, key=tries_differ, reverse=True)
    )
    return f"<h2>Tried twice</h2><table>{lines}</table>" if lines else ""


def _slowest(graded: Sequence[Result]) -> str:
    timed = sorted((row for row in graded if row["wall_s"] is not None), key=lambda row: -row["wall_s"])
    lines = "".join(
        f"<tr><td>{escape(row['student'])}</td><td>{row['wall_s']:.1f} s</td><td>{escape(row['clock'] or '')}</td></tr>"
        for row in timed[:SLOWEST]
    )
    return f"<h2>Slowest</h2><table>{lines}</table>" if lines else ""
