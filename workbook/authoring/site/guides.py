"""Generate the instructors' pages: each exercise's requirements, and the mistakes in its wrong answers."""

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from workbook.authoring.requirements import Requirement, read_requirements
from workbook.authoring.site.generated_class import STEM, generated_class
from workbook.authoring.tree import Tree, entries
from workbook.authoring.wrong_answers import Header, read_header
from workbook.criteria import vocabulary
from workbook.criteria.rules import Words
from workbook.exercise.definition import Exercise, load_exercise
from workbook.feedback.wording import points
from workbook.grading.gradebook import GradebookOptions, write_gradebook
from workbook.grading.pages import PAGES

FOLDER = "instructors"
_MOST_EXAMPLES = 3
_EXERCISE = """\
# Exercise {number}, for instructors: {title}

[The exercise](../exercises/{stem}.ipynb) · [The lesson](../notebooks/{stem}.ipynb)

{count} wrong answers test this exercise's judge. Each contains one mistake.

## Criteria

{criteria}

## Requirements

Each demand of the task, in its own words, and what judges it.

{requirements}

## Built-in wrong answers

{answers}
"""
_MISCONCEPTIONS = """\
# Misconceptions

The course has {count} wrong answers, which test its judge. Each contains one mistake, and must get the cause that this
table counts. So the numbers show how thoroughly a cause is tested. They don't show how often students make the mistake.
The likely cause is what a student reads, followed by its name. “…” stands for a value of the student's program.
[Teaching with this workbook](../exercises/teaching.md) lists what students get wrong in each lesson.

{table}
"""
_LIST = """\
# Exercises and their requirements

{table}

```{{toctree}}
:hidden:

{stems}
```
"""


@dataclass(frozen=True)
class Guides:
    """The generated pages for instructors."""

    tree: Tree

    @cached_property
    def _exercises(self) -> dict[str, Exercise]:
        return {stem: load_exercise(stem, self.tree.root) for stem in self.tree.exercise_stems()}

    @cached_property
    def _wrong(self) -> dict[str, dict[str, Header]]:
        """The headers of all wrong answers, keyed by exercise and name."""
        return {
            stem: {
                path.stem: read_header(path)
                for path in entries(self.tree.wrong_answers / stem)
                if path.suffix == ".py"
            }
            for stem in self._exercises
        }

    @cached_property
    def _likely(self) -> dict[str, dict[str, str]]:
        """The text under *Likely cause*, keyed by exercise and cause ID. A few causes have no such text."""
        shared = _likely_causes(Path(vocabulary.__file__).parent.glob("*.toml"))
        return {
            stem: {
                **shared,
                **_likely_causes((self.tree.root / "exercises" / "criteria").glob(f"{stem}.toml")),
            }
            for stem in self._exercises
        }

    def texts(self) -> Iterator[tuple[str, str]]:
        """Yield each page's file name and Markdown text."""
        for stem in self._exercises:
            yield f"{FOLDER}/{stem}.md", self._exercise(stem)
        yield f"{FOLDER}/misconceptions.md", self._misconceptions()
        yield f"{FOLDER}/exercises.md", self._list()

    def _exercise(self, stem: str) -> str:
        exercise, wrong = self._exercises[stem], self._wrong[stem]
        titles = {one.id: one.title for one in exercise.criteria}
        lost = Counter(name for header in wrong.values() for name in header.loses)
        criteria = [(one.title, points(one.points), str(lost[one.id])) for one in exercise.criteria]
        requirements = [_requirement(row, titles) for row in read_requirements(self.tree, stem)]
        answers = [
            (
                header.about or name.replace("_", " "),
                "; ".join(titles[one] for one in sorted(header.loses) if one in titles),
                ", ".join(f"`{cause}`" for cause in sorted(header.causes)),
            )
            for name, header in wrong.items()
        ]
        return _EXERCISE.format(
            stem=stem,
            number=stem[:2],
            title=exercise.source.title,
            count=len(wrong),
            criteria=_table(("criterion", "points", "wrong answers that lose it"), criteria),
            requirements=_table(("the task says", "judged by", "wrong answers"), requirements),
            answers=_table(("mistake", "loses", "cause"), answers),
        )

    def _misconceptions(self) -> str:
        found: dict[str, list[tuple[str, str]]] = defaultdict(list)
        for stem, wrong in self._wrong.items():
            for header in wrong.values():
                for cause in header.causes:
                    found[cause].append((stem, header.about))
        rows = []
        for cause, hits in sorted(found.items(), key=lambda one: (-len(one[1]), one[0])):
            places = " ".join(f"[{stem[:2]}]({stem}.md)" for stem in dict(hits))
            told = [about for _, about in hits if about]
            likely = self._likely[hits[0][0]].get(cause, "")
            rows.append((f"{likely} `{cause}`", str(len(hits)), places, " ".join(told[:_MOST_EXAMPLES])))
        table = _table(("likely cause", "wrong answers", "exercises", "for example"), rows)
        return _MISCONCEPTIONS.format(count=sum(map(len, self._wrong.values())), table=table)

    def _list(self) -> str:
        rows = [
            (
                f"[{stem[:2]} · {exercise.source.title}]({stem}.md)",
                points(exercise.max_points),
                str(len(exercise.criteria)),
                str(len(self._wrong[stem])),
            )
            for stem, exercise in self._exercises.items()
        ]
        table = _table(("exercise", "points", "criteria", "wrong answers"), rows)
        return _LIST.format(table=table, stems="\n".join(self._exercises))

    def write_class(self, folder: Path, scratch: Path) -> None:
        """Write the pages of a generated class to `folder`: class.html and one per student. `scratch` is temporary."""
        exercise = self._exercises[STEM]
        results = {result.key: result for result in generated_class(exercise, scratch)}
        write_gradebook(scratch, exercise, results, GradebookOptions(("html",)))
        folder.parent.mkdir(parents=True, exist_ok=True)
        (scratch / PAGES).rename(folder)


def _likely_causes(catalogs: Iterable[Path]) -> dict[str, str]:
    """Return the *Likely cause* text of each entry in the given feedback catalogs, with `…` for each placeholder."""
    return {
        cause: re.sub(r"\{[^}]*\}", "…", entry["because"])
        for path in catalogs
        for cause, entry in Words(str(path)).entries.items()
        if "because" in entry
    }


def _requirement(row: Requirement, titles: dict[str, str]) -> tuple[str, str, str]:
    said = " … ".join(row.sentences)
    if row.not_judged:
        return said, f"*not judged:* {row.not_judged}", ""
    judged = "; ".join(titles.get(one, one) for one in row.criteria)
    return said, judged, ", ".join(f"`{one}`" for one in row.wrong)


def _table(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a Markdown table."""
    lines = [heads, ["---"] * len(heads), *(list(map(_cell, row)) for row in rows)]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _cell(text: str) -> str:
    """Return a string on one line, for a table cell. If the string is itself a table row, dots separate its cells."""
    words = " · ".join(part.strip() for part in text.strip().strip("|").split("|"))
    return " ".join(words.split()).replace("<", "&lt;")
