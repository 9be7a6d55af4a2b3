"""Finds demands of a task that its table of requirements leaves out, by the words of commands and prohibitions."""

import re
from collections.abc import Iterable, Iterator

from workbook.authoring.task_text import folded, sentences

NOT_PART = "Not part of it"
"""The paragraph that begins so lists what is not judged."""
_DEMAND = re.compile(r"\b(must(n't)?|may not|do not|don't|can't|cannot|only)\b", re.IGNORECASE)


def untied_demands(task: str, quotes: Iterable[str]) -> Iterator[tuple[str, str]]:
    """Sentences of a task that command or forbid, and that no quotation ties to a requirement, each with the word."""
    known = [folded(quote) for quote in quotes]
    for sentence in sentences(task):
        found = _DEMAND.search(sentence.replace("’", "'"))
        if found is None or NOT_PART in sentence:
            continue
        if not any(quote in sentence or sentence in quote for quote in known):
            yield sentence, found[0]
