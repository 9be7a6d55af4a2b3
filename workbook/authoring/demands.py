"""Find demands that a task makes but its requirements table omits.

Words such as *must* and *only* mark a demand, and so does an imperative at the beginning of a sentence.
"""

import re
from collections.abc import Iterable, Iterator

from workbook.authoring.task_text import folded, sentences

NOT_PART = "Not judged"
"""The first words of the paragraph that lists a task's unjudged parts."""
_DEMAND = re.compile(r"\b(must(n't)?|may not|do not|don't|can't|cannot|only)\b", re.IGNORECASE)
_IMPERATIVE = re.compile(
    r"(Add|Ask|Call|Create|Give|Keep|Leave|Let|Make|Never|Publish|Put|Run|Send|Spin|Start|Stop|Subscribe|Use|Write)\b"
)


def untied_demands(task: str, quotes: Iterable[str]) -> Iterator[tuple[str, str]]:
    """Yield each sentence that demands or forbids something but isn't in `quotes`, with the word that marks it."""
    known = [folded(quote) for quote in quotes]
    for sentence in sentences(task):
        found = _DEMAND.search(sentence.replace("’", "'")) or _IMPERATIVE.match(sentence)
        if found is None or NOT_PART in sentence:
            continue
        if not any(quote in sentence or sentence in quote for quote in known):
            yield sentence, found[0]
