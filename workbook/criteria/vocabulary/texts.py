"""Judge strings that arrive on a topic."""

from collections.abc import Collection

from workbook.criteria.criterion import Topic
from workbook.criteria.rules import Words
from workbook.criteria.verdict import Verdict, passed
from workbook.criteria.vocabulary.field_checks import quoted_field_checks
from workbook.criteria.vocabulary.phrasing import listing
from workbook.criteria.vocabulary.topics import if_messages
from workbook.criteria.vocabulary.values import values
from workbook.recording.recording import Recording

WORDS = Words(__file__)

LONGEST_QUOTE = 60
_NO_TEXT = WORDS.cause("one-of.empty", ("topic", "text", "words", "quoted"), recheck_fields=True)
_OTHER_TEXT = WORDS.cause("one-of.other-text", ("topic", "text", "words"))
_EMPTY = WORDS.cause("has-text.empty", ("topic", "empty", "all", "quoted"), recheck_fields=True)


@if_messages
def one_of(recording: Recording, topic: Topic, allowed: Collection[str]) -> Verdict:
    """Check that every string on `topic` is one of the `allowed` words."""
    words = listing([f'"{word}"' for word in sorted(allowed, reverse=True)]).replace(" and ", " or ")
    said = values(recording, topic)
    wrong = [value for value in said if not isinstance(value, str) or value not in allowed]
    if not wrong:
        return passed("published: " + listing([f'"{word}"' for word in sorted(set(map(str, said)))]))
    text = str(wrong[0])[:LONGEST_QUOTE]
    if text:
        return _OTHER_TEXT.verdict(topic=topic, text=text, words=words)
    return _NO_TEXT.verdict(topic=topic, text=text, words=words, quoted=quoted_field_checks(recording))


@if_messages
def has_text(recording: Recording, topic: Topic) -> Verdict:
    """Check that no string on `topic` is empty."""
    said = values(recording, topic)
    empty = sum(text == "" for text in said)
    if not empty:
        return passed(f"{topic.name} has texts")
    return _EMPTY.verdict(topic=topic, empty=empty, all=len(said), quoted=quoted_field_checks(recording))
