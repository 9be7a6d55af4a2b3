"""Generate the site's error museum: one page for each error and each symptom, and two lists of these pages.

The exhibits come from `notebooks/sources/museum`. For each error, `errors.toml` adds the smallest program that raises
the error, and other wordings of the same error. Tests run these programs.
"""

import json
import re
import tomllib
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from workbook.authoring.lesson_links import title_of
from workbook.authoring.museum_pages import is_printed
from workbook.authoring.tree import Tree
from workbook.exercise.museum import Exhibit, load_museum

EXTRAS = Path(__file__).with_name("errors.toml")
FOLDER = "errors"
_LONGEST_NAME = 60
_MOST_LINES = 14
_OF_ROS = (
    "[WARN]",
    "terminate called",
    "New publisher discovered",
    "ERROR:",
    "cv2.error",
    "BrokenProcessPool",
)
"""Beginnings of printed messages that aren't Python exceptions."""
_INDEX = """\
# The error museum

Each page has the smallest program that raises its error. We run these programs, so the messages are exact. Search for
your message, or pick it from this list. [Symptoms without an error message](symptoms.md) have their own list."""
_SYMPTOMS = """\
# Symptoms without an error message

Nothing is printed, but the robot doesn't do what you expect."""


@dataclass(frozen=True)
class Extra:
    """An entry of `errors.toml` for one error: a program, the output that it `shows`, and other wordings (`also`).

    A symptom without an error message doesn't have a program.
    """

    symptom: str
    program: str = ""
    shows: str = ""
    also: tuple[str, ...] = ()


@dataclass(frozen=True)
class ErrorPage:
    """A page with all exhibits that have the same text."""

    name: str
    exhibits: tuple[Exhibit, ...]
    extra: Extra | None

    @property
    def title(self) -> str:
        """The error's exact text, or the symptom in words."""
        return _text_of(self.exhibits[0])

    @property
    def titles(self) -> tuple[str, ...]:
        """All titles under which a list shows the page. A symptom can have several, because it has no fixed wording."""
        return (self.title, *(self.extra.also if self.extra and not self.printed else ()))

    @property
    def printed(self) -> bool:
        """Whether Python or ROS prints the title."""
        return _is_printed(self.title)


@dataclass(frozen=True)
class ErrorPages:
    """All pages of the error museum."""

    tree: Tree

    @cached_property
    def pages(self) -> tuple[ErrorPage, ...]:
        """The pages, in lesson order."""
        extras = extras_by_symptom()
        groups: dict[str, list[Exhibit]] = defaultdict(list)
        for exhibit in load_museum(self.tree.root).exhibits:
            groups[_text_of(exhibit)].append(exhibit)
        found, names = [], set[str]()
        for text, exhibits in groups.items():
            name = _name_of(text)
            name = name if name not in names else f"{name}-{exhibits[0].lesson[:2]}"
            names.add(name)
            found.append(ErrorPage(name, tuple(exhibits), extras.get(text)))
        return tuple(found)

    def cells(self, lesson: str) -> frozenset[str]:
        """Return the IDs of a lesson's cells that these pages link to."""
        return frozenset(one.cell for page in self.pages for one in page.exhibits if one.lesson == lesson)

    def texts(self) -> Iterator[tuple[str, str]]:
        """Yield the file name and the Markdown text of each page, of the index, and of the list of symptoms."""
        for page in self.pages:
            yield f"{FOLDER}/{page.name}.md", self._page(page)
        yield f"{FOLDER}/index.md", self._index()
        yield f"{FOLDER}/symptoms.md", self._symptoms()

    def _page(self, page: ErrorPage) -> str:
        first = page.exhibits[0]
        parts = [f"# {_heading(page.title)}"]
        program = page.extra.program if page.extra else ""
        if page.extra and program:
            parts += ["The smallest program that raises this error:", _fenced(program, "python")]
            parts += ["It prints:", _fenced(page.extra.shows, "text")]
        for exhibit in page.exhibits:
            if exhibit is not first:
                parts.append(f"## Also in lesson {title_of(self.tree, exhibit.lesson)}")
            parts += [f"**What it means.** {exhibit.cause}", f"**The fix.** {exhibit.fix}"]
        if page.extra and page.extra.also and page.printed:
            parts += ["## Other wordings of this error", *(_fenced(one, "text") for one in page.extra.also)]
        elif page.extra and page.extra.also:
            parts.append("People also say: " + "; ".join(f"“{one}”" for one in page.extra.also) + ".")
        parts.append("## In the lesson")
        if not program:
            source, output = self._cell(first)
            where = f"[{title_of(self.tree, first.lesson)}](../notebooks/{first.lesson}.ipynb)"
            parts += [f"This cell of {where} shows it:", _fenced(source, "python")]
            if output:
                parts += ["Its output:", _fenced(_excerpt(output, first.shows), "text")]
        for exhibit in page.exhibits:
            link = f"#{cell_target(exhibit.lesson, exhibit.cell)}"
            parts.append(
                f"- [Lesson {title_of(self.tree, exhibit.lesson)}, with the cells around it]({link})"
            )
        return "\n\n".join([*parts, "[All errors](index.md) · [All symptoms](symptoms.md)", ""])

    def _cell(self, exhibit: Exhibit) -> tuple[str, str]:
        """Return the source and printed output of an exhibit's cell, or "" for both if the lesson has no such cell."""
        notebook = json.loads((self.tree.notebooks / f"{exhibit.lesson}.ipynb").read_text(encoding="utf-8"))
        for cell in notebook["cells"]:
            if cell["id"] == exhibit.cell:
                outputs = (part for output in cell["outputs"] for part in _printed(output))
                return "".join(cell["source"]), "\n".join(outputs)
        return "", ""

    def _index(self) -> str:
        return "\n\n".join([_INDEX, *self._lists(printed=True), self._tree(printed=True)])

    def _symptoms(self) -> str:
        return "\n\n".join([_SYMPTOMS, *self._lists(printed=False), self._tree(printed=False)])

    def _lists(self, *, printed: bool) -> Iterator[str]:
        """Yield a heading for each lesson, followed by links to its pages."""
        groups: dict[str, list[ErrorPage]] = defaultdict(list)
        for page in self.pages:
            if page.printed is printed:
                groups[page.exhibits[0].lesson].append(page)
        for lesson, pages in groups.items():
            yield f"## {title_of(self.tree, lesson)}"
            links = [f"- [{_heading(text)}]({page.name}.md)" for page in pages for text in page.titles]
            yield "\n".join(links)

    def _tree(self, *, printed: bool) -> str:
        """Return a hidden table of contents, which Sphinx requires for the pages."""
        names = [page.name for page in self.pages if page.printed is printed]
        return "\n".join(
            ["```{toctree}", ":hidden:", "", *(["symptoms"] if printed else []), *names, "```", ""]
        )


def cell_target(lesson: str, cell: str) -> str:
    """Return the link target of a lesson's cell."""
    return f"cell-{lesson}-{cell}".replace("_", "-")


def extras_by_symptom() -> dict[str, Extra]:
    """Return the entries of `errors.toml`, keyed by symptom."""
    rows = tomllib.loads(EXTRAS.read_text(encoding="utf-8")).get("error", [])
    return {row["symptom"]: Extra(**{**row, "also": tuple(row.get("also", ()))}) for row in rows}


def _is_printed(text: str) -> bool:
    return is_printed(text) or text.startswith(_OF_ROS)


def _text_of(exhibit: Exhibit) -> str:
    return exhibit.symptom.partition("; exit code")[0]


def _name_of(text: str) -> str:
    words = re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")
    return words[:_LONGEST_NAME].rstrip("-")


def _heading(text: str) -> str:
    """Return a title as Markdown: as code if a program prints it, otherwise unchanged."""
    return f"`{text}`" if _is_printed(text) and "`" not in text else text


def _fenced(text: str, language: str) -> str:
    return "\n".join([f"````{language}", text.rstrip("\n"), "````"])


def _printed(output: dict[str, object]) -> Iterator[str]:
    if output["output_type"] == "stream":
        yield "".join(_lines(output["text"]))
    elif output["output_type"] == "error":
        yield f"{output['ename']}: {output['evalue']}"
    else:
        data = output.get("data")
        if isinstance(data, dict) and "text/html" not in data:
            yield "".join(_lines(data.get("text/plain", "")))


def _lines(text: object) -> Sequence[str]:
    return text if isinstance(text, list) else [str(text)]


def _excerpt(output: str, shows: str) -> str:
    """Return the output or, if it's long, only the lines around the text given in the exhibit's `shows`."""
    lines = re.sub(r"\x1b\[[0-9;]*m", "", output).splitlines()
    if len(lines) <= _MOST_LINES:
        return "\n".join(lines)
    first = shows.splitlines()[0]
    at = next((number for number, line in enumerate(lines) if first in line), 0)
    start = max(0, min(at - _MOST_LINES // 2, len(lines) - _MOST_LINES))
    return "\n".join(lines[start : start + _MOST_LINES])
