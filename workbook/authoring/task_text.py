"""Extract a task's text and find the sentence that a quotation most likely comes from."""

import re
from collections.abc import Iterator
from difflib import SequenceMatcher

from workbook.exercise.source import ExerciseSource

CLOSE = 0.6
"""A similar sentence must contain at least this fraction of a quotation's words, in the same order."""
_OWN_BLOCK = re.compile(r"\s*(\||[-*] |\d+\. |#+ |$)")


def task_text(source: ExerciseSource) -> str:
    """Return a task's text, including its starter, as Markdown without comment marks."""
    starter = "\n".join(re.sub(r"^#+ ?", "", line.strip()) for line in source.starter_code.splitlines())
    return "\n\n".join((*source.story, starter, *source.afterword))


def folded(text: str) -> str:
    """Return the text on one line, with one space between words."""
    return " ".join(text.split())


def missing_words(quote: str, task: str) -> str:
    """Return a message for the author about a quotation that isn't in the task.

    The message gives the quotation's first missing sentence, and the task's most similar sentence if there is one.
    """
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
    """Return the task's sentence or table row that is most similar to a quotation, or None if all differ too much."""
    ranked = [(_likeness(quote.split(), one.split()), one) for one in sentences(task)]
    best, sentence = max(ranked, default=(0.0, ""), key=lambda pair: pair[0])
    return sentence if best else None


def _likeness(wanted: list[str], words: list[str]) -> float:
    """Return the similarity between `wanted` and the best part of `words`, from 0 (not close) to 1 (equal)."""
    blocks = SequenceMatcher(None, wanted, words, autojunk=False).get_matching_blocks()[:-1]
    shared = sum(block.size for block in blocks)
    if not shared or shared < CLOSE * len(wanted):
        return 0.0
    part = blocks[-1].b + blocks[-1].size - blocks[0].b
    return 2.0 * shared / (len(wanted) + part)


def sentences(text: str) -> Iterator[str]:
    """Yield a text's sentences, each on one line. Table rows, headings, and list items always begin a new sentence."""
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
