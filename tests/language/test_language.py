"""Every text that a person reads keeps to the word list, and to sentences of at most 25 words, as a rule."""

from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.language.ratchet import (
    COMMAND,
    LONG_SENTENCE,
    SOURCES,
    all_passages,
    exceptions,
    is_allowed,
    kept,
    long_sentences,
    old_words,
)
from tests.language.texts import ROOT, Passage, length, markdown, paths, sentences, string_passages
from tests.language.word_list import RULES

LONGEST_SENTENCE = 60
"""Words, outside of the lessons. A sentence that ends in a list of values may need them."""


def too_many(found: Counter[str], allowed: dict[str, int], complaints: dict[str, list[str]]) -> Iterator[str]:
    for path, n in sorted(found.items()):
        if n > allowed.get(path, 0):
            yield f"{path}: {n}, and {allowed.get(path, 0)} at most:\n  " + "\n  ".join(complaints[path])


def test_no_text_uses_words_that_the_style_replaces() -> None:
    found: Counter[str] = Counter()
    complaints: dict[str, list[str]] = {}
    for passage in all_passages():
        for rule, words in old_words(passage):
            if not is_allowed(rule, passage):
                found[passage.path] += 1
                line = f"{passage.where}: {words!r}; write: {RULES[rule].instead}"
                complaints.setdefault(passage.path, []).append(line)
    bad = list(too_many(found, kept()[0], complaints))
    assert not bad, "\n".join(bad)


def test_sentences_are_short() -> None:
    found: Counter[str] = Counter()
    complaints: dict[str, list[str]] = {}
    for passage in all_passages():
        for sentence in long_sentences(passage):
            found[passage.path] += 1
            line = f"{passage.where}: {length(sentence)} words: {sentence}"
            complaints.setdefault(passage.path, []).append(line)
    bad = list(too_many(found, kept()[1], complaints))
    assert not bad, "\n".join(bad)


def test_no_sentence_outside_the_lessons_is_endless() -> None:
    endless = [
        f"{passage.where}: {length(sentence)} words: {sentence}"
        for passage in all_passages()
        if not passage.path.startswith("notebooks/sources/")
        for sentence in long_sentences(passage)
        if length(sentence) > LONGEST_SENTENCE
    ]
    assert not endless, "\n".join(endless)


def test_only_lessons_still_use_words_of_the_list() -> None:
    others = [path for path in kept()[0] if not path.startswith("notebooks/sources/")]
    assert not others, f"name these in allowed.toml, with a reason, or rewrite them: {others}"


def test_what_is_kept_names_files_that_are_there() -> None:
    gone = [path for counts in kept() for path in counts if not (ROOT / path).is_file()]
    assert not gone, f"run `{COMMAND}`: {gone}"


@pytest.mark.parametrize("one", exceptions(), ids=lambda one: f"{one['rule']}-{one['file']}")
def test_each_exception_is_needed_and_has_a_reason(one: dict[str, str]) -> None:
    assert one["reason"].endswith(".")
    uses = [
        passage
        for passage in all_passages()
        if passage.path == one["file"] and one["text"] in passage.text
        if any(rule == one["rule"] for rule, _ in old_words(passage))
    ]
    assert uses, f"no passage needs it: delete it from allowed.toml: {one}"


@pytest.mark.parametrize(
    ("text", "rule"),
    [
        ("Mend the first fault.", "mend"),
        ("Whoever listens is misled.", "whoever"),
        ("An int arrives as 0.0 with stock ROS.", "stock ROS"),
        ("There are twins on the graph.", "twins"),
        ("The colour is grey.", "British -our"),
        ("It waits for ever.", "for ever"),
    ],
)
def test_the_list_finds_its_words(text: str, rule: str) -> None:
    assert RULES[rule].found(text)


@pytest.mark.parametrize(
    "text", ["a recommended depth", "an amended line", "outdoors", "the callback stands in a group"]
)
def test_the_list_leaves_other_words_alone(text: str) -> None:
    assert not old_words(Passage("x", 1, text))


def test_each_kind_of_text_is_read() -> None:
    for patterns, passages in SOURCES:
        read = [passage for path in paths(patterns) for passage in passages(path)]
        assert len(read) > 100, patterns


def test_a_passage_is_a_paragraph_a_cell_or_an_item() -> None:
    lines = ["# A heading", "", "One line", "goes on.", "- an item", "- another `x y` item", "| a cell | another |", "",
             "```python", "no_words = here", "```", "", "    make test"]  # fmt: skip
    texts = [passage.text for passage in markdown("x", 1, lines)]
    assert texts == ["A heading", "One line goes on.", "an item", "another Code item", "a cell", "another"]


def test_an_option_and_its_explanation_are_two_passages() -> None:
    lines = ["- **a** Sixty beeps, as", "  ordered", "  when `beeps > 50`", "  ✗ It takes seconds,", "  not hertz.",
             "- **b** None", "  ✓ It stops."]  # fmt: skip
    found = [(passage.line, passage.text) for passage in markdown("x", 1, lines)]
    assert found == [
        (1, "a Sixty beeps, as ordered"),
        (4, "It takes seconds, not hertz."),
        (6, "b None"),
        (7, "It stops."),
    ]


def test_a_program_in_a_string_is_read_as_code(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tests.language.texts.ROOT", tmp_path)
    module = tmp_path / "module.py"
    module.write_text(
        'CODE = """\\\nspin(node)  # no word of it\nprint("It ends on Ctrl-C.")\n"""\nTEXT = "It spins on."\n'
    )
    found = [(passage.line, passage.text) for passage in string_passages(module)]
    assert sorted(found) == [(2, "It ends on Ctrl-C."), (5, "It spins on.")]


def test_strings_of_code_are_read_with_values_and_without_docstrings() -> None:
    source = ROOT / "exercises" / "criteria" / "01_the_context.py"
    texts = [passage.text for passage in string_passages(source)]
    assert "The program makes one more node than it needs." in texts
    assert not any(text.startswith("How exercise 01 is judged") for text in texts)
    assert "the words 5 after Ctrl-C, and not before" in texts


def test_sentences_end_at_full_stops_and_not_within_numbers() -> None:
    said = sentences(
        Passage("x", 1, 'Wait 0.5 s. "Then" go on. Code runs! Is it over? rclpy ends. spin_once, too.')
    )
    assert said == [
        "Wait 0.5 s.",
        '"Then" go on.',
        "Code runs!",
        "Is it over?",
        "rclpy ends.",
        "spin_once, too.",
    ]
    assert length("Wait 0.5 s, at most.") == 5
    assert length("one " * LONG_SENTENCE) == LONG_SENTENCE
