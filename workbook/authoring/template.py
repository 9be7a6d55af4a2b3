"""Rules for a lesson's structure: its sections, their order, and what each section must contain.

A rule takes a section and yields error messages for the author. docs/lessons.md explains the structure.
"""

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass

from workbook.authoring.document import OPENING, Cell, heading_of
from workbook.authoring.marks import marks_in_html

FACTS = ("Minutes", "You need", "You will be able to", "Not covered")
QUESTIONS = range(3, 6)
EXPERIMENTS = range(2, 4)
TAKE_AWAY_LINES = 5
WRONG_CLAIMS_COUNT = 2
DEEPER_NEEDS = ("Predict", "Run it", "Look inside", "Take away")
"""The sections that an optional deeper notebook needs."""
OFFICIAL = "https://docs.ros.org/"
GOOD_ANSWER = "What a good answer covers"
WRONG_CLAIMS = "What to check in the reply"

_PREDICT = re.compile(r"^\s*predict\(\s*(?P<quote>['\"])(?P<choice>.*?)(?P=quote)", re.MULTILINE)
_RECALL = re.compile(r"^\s*(?:recall|reveal|.*\bpredicted)\(", re.MULTILINE)
_OPTION = re.compile(r"^- \*\*[a-e]\*\* \S", re.MULTILINE)
_QUESTION = re.compile(r"^\*\*(?P<number>\d)\. .+\*\*\s*$", re.MULTILINE)
_DETAILS = re.compile(r"<details>\s*<summary>(?P<summary>.*?)</summary>(?P<body>.*?)</details>", re.DOTALL)
_SUMMARY = re.compile(r"<summary>(.*?)</summary>", re.DOTALL)
_FENCE = re.compile(r"^(`{3,}|~{3,}).*?^\1", re.MULTILINE | re.DOTALL)
_BLANK = re.compile(r"\.\.\.|___|# TODO")
_SETUP = re.compile(r"^\s*(%load_ext|[%!]pip|!apt|%conda)", re.MULTILINE)


@dataclass(frozen=True)
class Section:
    """A section of a lesson: a heading and its cells, including the heading's own cell."""

    title: str
    cells: tuple[Cell, ...]
    number: int
    """The lesson's number."""
    has_exercise: bool
    is_deeper: bool = False
    """Whether the section is in an optional deeper notebook."""

    @property
    def line(self) -> int:
        """The section's first line in the lesson's text."""
        return self.cells[0].line if self.cells else 1

    @property
    def markdown(self) -> str:
        """The text of the section's Markdown cells, separated by blank lines."""
        return "\n\n".join(cell.source for cell in self.cells if cell.kind == "markdown")

    @property
    def code(self) -> tuple[Cell, ...]:
        """The section's code cells, in order."""
        return tuple(cell for cell in self.cells if cell.kind == "code")


Rule = Callable[[Section], Iterable[str]]


def shape_violations(
    cells: Sequence[Cell], number: int, *, has_exercise: bool, is_deeper: bool = False
) -> Iterator[tuple[int, str]]:
    """Yield a line number and a message for each error in a lesson's structure. Line 0 means the whole lesson.

    A deeper notebook may omit sections and have any number of experiments.
    """
    yield from _headings_open_cells(cells)
    yield from _marks_in_summaries(cells)
    sections = split(cells, number, has_exercise=has_exercise, is_deeper=is_deeper)
    found = [section.title for section in sections[1:]]
    if found != list(SHAPE):
        yield from ((0, words) for words in _order(found, DEEPER_NEEDS if is_deeper else tuple(SHAPE)))
    by_title = {section.title: section for section in sections}
    for title, rules in {OPENING: _OPENING_RULES, **SHAPE}.items():
        section = by_title.get(title)
        if section is None:
            continue
        shown = "the opening" if title == OPENING else f"## {title}"
        for rule in rules:
            yield from ((section.line, f"{shown}: {words}") for words in rule(section))
    if not any(cell.kind == "code" and _RECALL.search(cell.source) for cell in cells):
        yield 0, "no cell shows how a prediction turned out: reveal('late-joiner')"
    for cell in cells:
        if cell.kind == "code" and _SETUP.search(cell.source):
            yield (
                cell.line,
                f"cell {cell.id} sets something up: a lesson has no set-up cell, the environment is there",
            )


def split(
    cells: Sequence[Cell], number: int, *, has_exercise: bool, is_deeper: bool = False
) -> list[Section]:
    """Return the sections in order. The first one is the opening, before any `## ` heading."""
    groups: list[tuple[str, list[Cell]]] = [(OPENING, [])]
    for cell in cells:
        heading = heading_of(cell)
        if heading is not None:
            groups.append((heading, []))
        groups[-1][1].append(cell)
    return [Section(title, tuple(inside), number, has_exercise, is_deeper) for title, inside in groups]


def _order(found: list[str], needed: Sequence[str]) -> Iterator[str]:
    for title in SHAPE:
        if title not in found and title in needed:
            yield f"the section '## {title}' is missing"
        if found.count(title) > 1:
            yield f"the section '## {title}' is there more than once"
    for title in found:
        if title not in SHAPE:
            yield f"'## {title}' is not a section of a lesson; use '### ' for your own headings"
    known = [title for title in found if title in SHAPE]
    if sorted(set(known), key=list(SHAPE).index) != list(dict.fromkeys(known)):
        yield f"the sections must come in this order: {', '.join(SHAPE)}"


def _headings_open_cells(cells: Sequence[Cell]) -> Iterator[tuple[int, str]]:
    for cell in cells:
        if cell.kind == "markdown":
            inner = _FENCE.sub("", cell.source).split("\n")[1:]
            for line in inner:
                if re.match(r"##? ", line):
                    yield cell.line, f"cell {cell.id}: the heading {line!r} must be the first line of a cell"


def _marks_in_summaries(cells: Sequence[Cell]) -> Iterator[tuple[int, str]]:
    for cell in cells:
        if cell.kind != "markdown":
            continue
        for summary in _SUMMARY.findall(_FENCE.sub("", cell.source)):
            if any(marks_in_html(summary)):
                yield (
                    cell.line,
                    f"{summary!r} is shown as it is written: in a summary, write <code>x</code> and <em>x</em>",
                )


def _opening(section: Section) -> Iterator[str]:
    first = section.cells[0] if section.cells else Cell("code", "")
    title = f"# {section.number:02d} · {'Deeper: ' if section.is_deeper else ''}"
    if first.kind != "markdown" or not first.source.startswith(title):
        example = "clocks" if section.is_deeper else "Timers"
        yield f"the first cell must begin with the title, '{title}{example}' for example"
        return
    body = [line for line in first.source.split("\n")[1:] if line.strip()]
    if not body or body[0].startswith("- "):
        yield "one sentence of why a robot needs this must follow the title"
    for fact in FACTS:
        if not re.search(rf"^- \*\*{fact}:\*\*(?: |\n  - )\S", first.source, re.MULTILINE):
            yield f"the first cell needs the line '- **{fact}:** …', or a list below '- **{fact}:**'"
    minutes = re.search(r"^- \*\*Minutes:\*\* (.*)$", first.source, re.MULTILINE)
    if minutes and not minutes[1].strip().isdigit():
        yield f"the minutes must be a number, not {minutes[1].strip()!r}"


def _predicts(section: Section) -> Iterator[str]:
    if len(_OPTION.findall(section.markdown)) < 3:
        yield "needs at least three options to choose from, as lines '- **a** It waits.'"
    if not any(_PREDICT.search(cell.source) for cell in section.code):
        yield "needs a code cell in which the student chooses, predict('late-joiner')"


def _runs(section: Section) -> Iterator[str]:
    if not section.code:
        yield "needs at least one code cell that runs it"


def _explains(section: Section) -> Iterator[str]:
    text = section.cells[0].source.split("\n", 1)
    words = " ".join(
        [*text[1:], *(cell.source for cell in section.cells[1:] if cell.kind == "markdown")]
    ).split()
    if len(words) < 30:
        yield f"needs a text of at least 30 words, it has {len(words)}"


def _experiments(section: Section) -> Iterator[str]:
    groups: list[tuple[str, list[Cell]]] = []
    for cell in section.cells:
        started = [
            line
            for line in _FENCE.sub("", cell.source).split("\n")
            if cell.kind == "markdown" and line.startswith("### ")
        ]
        if started:
            groups.append((started[0][4:].strip(), []))
        if groups:
            groups[-1][1].append(cell)
    if len(groups) not in EXPERIMENTS and not section.is_deeper:
        yield f"needs two or three experiments, each under a '### ' heading; it has {len(groups)}"
    for title, cells in groups:
        code = [cell for cell in cells if cell.kind == "code"]
        guess = next((place for place, cell in enumerate(code) if _PREDICT.search(cell.source)), None)
        if guess is None and section.is_deeper:
            continue
        if guess is None:
            yield f"the experiment {title!r} needs its own prediction, predict('late-joiner')"
        elif guess == len(code) - 1:
            yield f"the experiment {title!r} needs a code cell after the prediction that runs it"


def _goes_wrong(section: Section) -> Iterator[str]:
    if not section.code:
        yield "needs a code cell that provokes the error or the silence"
        return
    place = section.cells.index(section.code[0])
    if not any(cell.kind == "markdown" for cell in section.cells[place + 1 :]):
        yield "must explain, after the code that provokes it, what happened and how to fix it"


def _fades(section: Section) -> Iterator[str]:
    if len(section.code) < 2:
        yield "needs a worked example and then a faded one: at least two code cells"
    elif not any(_BLANK.search(cell.source) for cell in section.code[1:]):
        yield "the faded example leaves something blank for the student: ___, ... or # TODO"
    link = rf"\]\(\.\./exercises/{section.number:02d}_\w+\.ipynb\)"
    if section.has_exercise and not re.search(link, section.markdown):
        yield f"must link to the exercise: [..](../exercises/{section.number:02d}_….ipynb)"


def _questions(section: Section) -> Iterator[str]:
    pieces = _QUESTION.split(section.markdown)
    numbers = [int(text) for text in pieces[1::2]]
    if len(numbers) not in QUESTIONS:
        yield f"needs three to five questions, as lines '**1. How often does it fire?**'; it has {len(numbers)}"
    if numbers != list(range(1, len(numbers) + 1)):
        yield f"the questions must be numbered from 1 on, not {numbers}"
    for number, text in zip(numbers, pieces[2::2], strict=True):
        options = list(_DETAILS.finditer(text))
        if len(options) < 2:
            yield (
                f"question {number} needs options, each as "
                "<details><summary>a) Twice</summary>, an explanation, </details>"
            )
            continue
        signs = [option["body"].strip()[:1] for option in options]
        for option, sign in zip(options, signs, strict=True):
            shown = option["summary"].strip()
            if sign not in ("✓", "✗"):
                yield f"question {number}, option {shown!r}: the explanation must begin with ✓ or ✗"
            elif len(option["body"].split()) < 4:
                yield f"question {number}, option {shown!r} needs an explanation"
            elif "\n\n" not in option["body"].rstrip(" "):
                yield f"question {number}, option {shown!r}: leave an empty line after </summary>"
        if signs.count("✓") != 1:
            yield f"question {number} needs exactly one option with ✓, but has {signs.count('✓')}"


def _talks(section: Section) -> Iterator[str]:
    if not re.search(r"^```text\n.*\S.*\n```$", section.markdown, re.MULTILINE | re.DOTALL):
        yield "needs the prompt, as a block that can be copied: ```text, the prompt, ```"
    folds = {option["summary"].strip(): option["body"] for option in _DETAILS.finditer(section.markdown)}
    if GOOD_ANSWER not in folds:
        yield f"needs <details><summary>{GOOD_ANSWER}</summary>, an empty line, the text, </details>"
    claims = re.findall(r"^- \*\*.+?:\*\* \S", folds.get(WRONG_CLAIMS, ""), re.MULTILINE)
    if len(claims) != WRONG_CLAIMS_COUNT:
        yield (
            f"needs <details><summary>{WRONG_CLAIMS}</summary> with two wrong claims, "
            f"each as '- **The claim:** the truth'; it has {len(claims)}"
        )


def _takes_away(section: Section) -> Iterator[str]:
    lines = re.findall(r"^- \S", section.markdown, re.MULTILINE)
    if len(lines) != TAKE_AWAY_LINES and not section.is_deeper:
        yield f"needs exactly five lines that begin with '- ', it has {len(lines)}"
    if not re.search(r"^\*\*Next:\*\* \S", section.markdown, re.MULTILINE):
        yield "needs the line '**Next:** …' with the next lesson"
    more = re.search(r"^\*\*More:\*\* .*(?:\n.+)*", section.markdown, re.MULTILINE)
    if more is None or OFFICIAL not in more[0]:
        yield f"needs the line '**More:** …' with a link to the official documentation, {OFFICIAL}…"


_OPENING_RULES: tuple[Rule, ...] = (_opening,)
SHAPE: dict[str, tuple[Rule, ...]] = {
    "Predict": (_predicts,),
    "Run it": (_runs,),
    "Look inside": (_explains,),
    "Change it": (_experiments,),
    "When it goes wrong": (_goes_wrong,),
    "From a worked example to your own": (_fades,),
    "Check yourself": (_questions,),
    "Talk it through": (_talks,),
    "Take away": (_takes_away,),
}
