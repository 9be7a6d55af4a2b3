"""Judges texts that arrive on a topic."""

from collections.abc import Collection

from workbook.criteria.criterion import Topic
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.vocabulary.field_checks import quoting_field_checks
from workbook.criteria.vocabulary.phrasing import count, listing
from workbook.criteria.vocabulary.topics import if_messages
from workbook.criteria.vocabulary.values import values
from workbook.recording.recording import Recording

LONGEST_QUOTE = 60


@if_messages
def one_of(recording: Recording, topic: Topic, allowed: Collection[str]) -> Verdict:
    """Every text is one of the allowed words."""
    words = listing([f'"{word}"' for word in sorted(allowed, reverse=True)]).replace(" and ", " or ")
    said = values(recording, topic)
    wrong = [value for value in said if not isinstance(value, str) or value not in allowed]
    if not wrong:
        return passed("published: " + listing([f'"{word}"' for word in sorted(set(map(str, said)))]))
    text = str(wrong[0])[:LONGEST_QUOTE]
    saw, try_this = f'"{text}" on {topic.name}', f"Publish exactly one of {words}."
    if text == "":
        return failed(
            "one-of.empty",
            saw,
            words,
            quoting_field_checks(
                recording,
                "The text is empty: the message was published before its data was set, or a field name is "
                "misspelled.",
            ),
            try_this,
            recheck_fields=True,
        )
    return failed(
        "one-of.other-text", saw, words, "Other programs compare this text letter by letter.", try_this
    )


@if_messages
def has_text(recording: Recording, topic: Topic) -> Verdict:
    """No text is empty."""
    said = values(recording, topic)
    empty = sum(text == "" for text in said)
    if not empty:
        return passed(f"{topic.name} has texts")
    return failed(
        "has-text.empty",
        f"an empty text on {topic.name} in {empty} of {count(len(said), 'message')}",
        "a text in every message",
        quoting_field_checks(
            recording,
            "The message was published before its data was set, or a field name is misspelled.",
        ),
        'Give the message its text: String(data="alive").',
        recheck_fields=True,
    )
