"""Generate the lists of lessons: the page next to the notebooks, and the table in the README."""

import json
import re
import threading
import tomllib
from contextlib import suppress

from workbook.authoring.lesson_links import lesson_link, title_of
from workbook.authoring.museum_pages import GLOSSARY, MUSEUM
from workbook.authoring.tree import Tree
from workbook.exercise.source import ExerciseSource, SourceError, load

PLANNED = "planned.toml"
RUN_TIMES = "run_times.json"
_WRITING = threading.Lock()
_MINUTES = re.compile(r"\*\*Minutes:\*\* (\d+)")


def list_page(tree: Tree) -> str:
    """Return the page that lists each lesson's reading time in minutes, run time in seconds, and exercise."""
    times = run_times(tree)
    lines = [
        "# The lessons",
        "",
        "Take the lessons in this order. *You* is the time that a reader needs for a lesson, and *cells* is the time",
        f"that its code needs to run. New words are in the [glossary]({GLOSSARY}). If something fails, see the",
        f"[error museum]({MUSEUM}).",
        "",
        "| lesson | you | cells | exercise |",
        "|---|---:|---:|---|",
    ]
    exercises = _exercises(tree)
    for stem in tree.lesson_stems():
        found = _MINUTES.search((tree.sources / f"{stem}.py").read_text(encoding="utf-8"))
        minutes = f"{found[1]} min" if found else ""
        cells = f"{times[stem]} s" if stem in times else ""
        exercise = ""
        if stem in exercises:
            one = exercises[stem]
            exercise = f"[{one.title}](../exercises/{stem}.ipynb), {one.minutes} min"
        lines.append(f"| {lesson_link(tree, stem)} | {minutes} | {cells} | {exercise} |")
    return "\n".join(lines) + "\n"


def table(tree: Tree) -> str:
    """Return the README's table of lessons and their exercises. The planned lessons are listed below the table."""
    exercises = _exercises(tree)
    lines = ["| | lesson | exercise |", "|---|---|---|"]
    for stem in tree.main_stems():
        title = title_of(tree, stem).partition(" · ")[2]
        own = [exercise for exercise in exercises.values() if exercise.stem[:2] == stem[:2]]
        link = f"[{own[0].title}](exercises/{own[0].stem}.ipynb)" if own else "in the lesson, not graded"
        lesson = f"[{title}](notebooks/{stem}.ipynb)"
        if deeper := tree.deeper_stem(stem):
            lesson += f" · [deeper](notebooks/{deeper}.ipynb)"
        lines.append(f"| {stem[:2]} | {lesson} | {link} |")
    titles = [f"*{title}*" for title in planned(tree).values()]
    if titles:
        lines += ["", f"Planned: {', '.join(titles)}."]
    return "\n".join(lines)


def planned(tree: Tree) -> dict[str, str]:
    """Return the titles of planned lessons, keyed by number. A lesson that has a text is no longer planned."""
    path = tree.sources / PLANNED
    if not path.is_file():
        return {}
    titles: dict[str, str] = tomllib.loads(path.read_text(encoding="utf-8"))
    written = {stem[:2] for stem in tree.lesson_stems()}
    return {number: title for number, title in titles.items() if number not in written}


def _exercises(tree: Tree) -> dict[str, ExerciseSource]:
    found = {}
    for stem in tree.exercise_stems():
        with suppress(SourceError):  # building the exercise reports it
            found[stem] = load(tree.solutions / f"{stem}.py")
    return found


def run_times(tree: Tree) -> dict[str, int]:
    """Return the last measured run time of each lesson's cells, in seconds, keyed by stem."""
    path = tree.sources / RUN_TIMES
    if not path.is_file():
        return {}
    times: dict[str, int] = json.loads(path.read_text(encoding="utf-8"))
    return times


def note_run_times(tree: Tree, measured: dict[str, float]) -> None:
    """Store measured run times, rounded to five seconds so that ordinary variation doesn't change the file.

    A lock protects the file, because lessons are built in parallel.
    """
    rounded = {stem: max(5, 5 * round(seconds / 5)) for stem, seconds in measured.items()}
    with _WRITING:
        times = run_times(tree) | rounded
        known = {stem: times[stem] for stem in sorted(times) if stem in tree.lesson_stems()}
        (tree.sources / RUN_TIMES).write_text(json.dumps(known, indent=1) + "\n", encoding="utf-8")
