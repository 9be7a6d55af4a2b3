"""What a student reads of a task, and which of its sentences a quotation is likely to mean."""

import re
from collections.abc import Iterator
from difflib import SequenceMatcher

from workbook.exercise.source import ExerciseSource

CLOSE = 0.6
"""Share of a quotation's words that a sentence must have, in the same order, to be called its nearest."""
_OWN_BLOCK = re.compile(r"\s*(\||[-*] |\d+\. |#+ |$)")


def task_text(source: ExerciseSource) -> str:
    """The text of a task and its starter, as Markdown and without comment marks."""
    starter = "\n".join(re.sub(r"^#+ ?", "", line.strip()) for line in source.starter_code.splitlines())
    return "\n\n".join((*source.story, starter, *source.afterword))


def folded(text: str) -> str:
    """The text in one line, with one space between words."""
    return " ".join(text.split())


def missing_words(quote: str, task: str) -> str:
    """What to tell of a quotation that the task does not have: its first sentence that is missing, and the nearest."""
    known = folded(task)
    gone = next((one for one in sentences(quote) if one not in known), None)
    if gone is None:
        return "the task has these sentences at different places: make a list of them"
    words = f"the task does not say {gone!r}"
    near = nearest_sentence(gone, task)
    return (
        f"{words}; the nearest is {near!r}" if near else f"{words}, nor anything like it: quote its own words"
    )


def nearest_sentence(quote: str, task: str) -> str | None:
    """The sentence or table row of the task with a part that is most like a quotation; None if none is close."""
    ranked = [(_likeness(quote.split(), one.split()), one) for one in sentences(task)]
    best, sentence = max(ranked, default=(0.0, ""), key=lambda pair: pair[0])
    return sentence if best else None


def _likeness(wanted: list[str], words: list[str]) -> float:
    """How like a part of the `words` is to the wanted ones: 1 the same, 0 not close."""
    blocks = SequenceMatcher(None, wanted, words, autojunk=False).get_matching_blocks()[:-1]
    shared = sum(block.size for block in blocks)
    if not shared or shared < CLOSE * len(wanted):
        return 0.0
    part = blocks[-1].b + blocks[-1].size - blocks[0].b
    return 2.0 * shared / (len(wanted) + part)


def sentences(text: str) -> Iterator[str]:
    """The sentences of a text, folded; a table row, a heading or the item of a list is no part of another."""
    block: list[str] = []
    for line in [*text.splitlines(), ""]:
        if _OWN_BLOCK.match(line):
            yield from _split(block)
            block = []
        block.append(line)
    yield from _split(block)


def _split(block: list[str]) -> Iterator[str]:
    one = folded("\n".join(block))
    if one.startswith("|"):
        yield one
    else:
        yield from filter(None, re.split(r"(?<=[.!?]) ", one))
