"""Keep a lesson's links to its neighbors up to date: its `**Before:**`, `**Deeper:**`, and `**Next:**` lines."""

import re
from collections.abc import Iterator
from dataclasses import dataclass

from workbook.authoring.tree import Tree

LAST = "none yet; this is the last lesson."
_PARAGRAPH = r"^# \*\*{name}:\*\*(?:.*\n)(?:# \S.*\n)*"
_BEFORE = re.compile(_PARAGRAPH.format(name="Before"), re.MULTILINE)
_NEXT = re.compile(_PARAGRAPH.format(name="Next"), re.MULTILINE)
_DEEPER = re.compile(_PARAGRAPH.format(name="Deeper"), re.MULTILINE)
_EMPTY_LINES = re.compile(r"(?:#\n){2,}\Z")
_LESSON_LINK = re.compile(r"\[(?P<text>[^\]]*)\]\((?P<stem>(?P<number>\d\d)_\w+)\.ipynb\)")
_YOU_NEED = re.compile(r"^# - \*\*You need:\*\*")


@dataclass(frozen=True)
class Neighbor:
    """A lesson that another lesson links to: the previous one, the next one, or the deeper notebook."""

    stem: str
    title: str
    """The title with the lesson's number, such as "05 · Timers"."""

    @property
    def link(self) -> str:
        """A Markdown link to the lesson's notebook in the same folder, with the title as its text."""
        return f"[{self.title}]({self.stem}.ipynb)"


def title_of(tree: Tree, stem: str) -> str:
    """Return a lesson's title, such as "05 · Timers", or the stem if the text has no title."""
    for line in (tree.sources / f"{stem}.py").read_text(encoding="utf-8").splitlines():
        if line.startswith("# # "):
            return line[4:].strip()
    return stem


def lesson_link(tree: Tree, stem: str) -> str:
    """Return a Markdown link to a lesson, for a page in the notebooks folder."""
    return Neighbor(stem, title_of(tree, stem)).link


def neighbors(tree: Tree, stem: str) -> tuple[Neighbor | None, Neighbor | None]:
    """Return the main lessons before and after a lesson, with None for a missing one.

    For a "deeper" notebook, these are the lesson that it extends and the next main lesson.
    """
    stems = tree.main_stems()
    before = [other for other in stems if other < stem][-1:]
    after = [other for other in stems if other > stem][:1]

    def found(one: list[str]) -> Neighbor | None:
        return Neighbor(one[0], title_of(tree, one[0])) if one else None

    return found(before), found(after)


def linked(text: str, before: Neighbor | None, after: Neighbor | None, deeper: Neighbor | None = None) -> str:
    """Return the lesson's text with correct links. The author's words around a link are kept if it was correct."""
    text = _BEFORE.sub("", text)
    optional = _DEEPER.search(text)
    text = _DEEPER.sub("", text)
    found = _NEXT.search(text)
    if found is None:  # `shape_violations` reports the missing line
        return text
    lines = f"# **Before:** {before.link}\n#\n" if before else ""
    if deeper is not None:
        lines += _onward("Deeper", optional[0] if optional else "", deeper) + "#\n"
    start = _EMPTY_LINES.sub("#\n", text[: found.start()])
    onward = _onward("Next", found[0], after) if after else f"# **Next:** {LAST}\n"
    return start + lines + onward + text[found.end() :]


def _onward(name: str, paragraph: str, there: Neighbor) -> str:
    link = _LESSON_LINK.search(paragraph)
    if link is None or link["stem"] != there.stem:
        return f"# **{name}:** {there.link}\n"
    return paragraph[: link.start()] + there.link + paragraph[link.end() :]


def _links_put_right(tree: Tree, stem: str, text: str) -> str:
    deeper = tree.deeper_stem(stem)
    return linked(text, *neighbors(tree, stem), Neighbor(deeper, title_of(tree, deeper)) if deeper else None)


def write_links(tree: Tree) -> list[str]:
    """Correct the links in all lessons. Return the stems of the lessons that changed."""
    changed = []
    for stem in tree.lesson_stems():
        path = tree.sources / f"{stem}.py"
        text = path.read_text(encoding="utf-8")
        right = _links_put_right(tree, stem, text)
        if right != text:
            path.write_text(right, encoding="utf-8")
            changed.append(stem)
    return changed


def link_violations(tree: Tree, stem: str, text: str) -> Iterator[tuple[int, str]]:
    """Yield a line number and a message if links to neighbors are outdated, and for each bad link under "You need".

    Such a link must lead to an earlier lesson and show only its number.
    """
    right = _links_put_right(tree, stem, text)
    if right != text:
        given, wanted = text.splitlines(), right.splitlines()
        pairs = enumerate(zip(given, wanted, strict=False), start=1)
        line = next((number for number, (one, other) in pairs if one != other), len(given))
        yield (
            line,
            "the **Before:**, **Deeper:** and **Next:** lines don't match the neighboring lessons: "
            "run `make notebooks`",
        )
    for number, words in enumerate(text.splitlines(), start=1):
        if not _YOU_NEED.search(words):
            continue
        for link in _LESSON_LINK.finditer(words):
            if link["stem"] >= stem or link["text"] != link["number"]:
                yield (
                    number,
                    f"'You need' links to earlier lessons, such as [{link['number']}]({link['stem']}.ipynb); "
                    f"{link[0]} is not such a link",
                )
