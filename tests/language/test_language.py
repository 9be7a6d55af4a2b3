"""Check that every text, docstring, and comment keeps to the word list, and to sentences of at most 25 words."""

from pathlib import Path

import pytest

from tests.language.complaints import (
    EXPLANATIONS,
    LONG_SENTENCE,
    MOST_WORDS,
    SOURCES,
    all_passages,
    broken_rules,
    complaints,
    exceptions,
)
from tests.language.docstrings import all_without_verbs, is_verb
from tests.language.texts import (
    ROOT,
    Passage,
    catalog_passages,
    comment_passages,
    length,
    markdown,
    paths,
    sentences,
    string_passages,
    template_passages,
)
from tests.language.word_list import RULES


def test_every_text_keeps_to_the_word_list_and_to_short_sentences() -> None:
    found = list(complaints(all_passages()))
    assert not found, "\n".join(found)


@pytest.mark.parametrize("one", exceptions(), ids=lambda one: f"{one['rule']}-{one['file']}")
def test_each_exception_is_needed_and_has_a_reason(one: dict[str, str]) -> None:
    assert one["reason"].endswith(".")
    uses = [
        passage.where
        for passage in all_passages()
        if passage.path == one["file"]
        for rule, text, _ in broken_rules(passage)
        if rule == one["rule"] and one["text"] in text
    ]
    assert uses, f"no passage needs it: delete it from allowed.toml: {one}"


@pytest.mark.parametrize(
    ("text", "rule"),
    [
        ("Mend the first fault.", "mend"),
        ("Whoever listens is misled.", "whoever"),
        ("An int arrives as 0.0 with stock ROS.", "stock ROS"),
        ("There are twins in the graph.", "twins"),
        ("The colour is grey.", "British -our"),
        ("It waits for ever.", "for ever"),
        ("The node is made anew.", "anew"),
        ("The battery comes at 0.5 Hz.", "as it was"),
        ("We plot what is orange.", "what-clause"),
        ("It is an array of NumPy.", "of a library"),
        ("The camera hears the new angle.", "hears"),
        ("It has a thread of its own.", "of its own"),
        ("It raises no error, and nothing is logged.", ", and nothing"),
        ("Its stamp is that of the image.", "vague pronoun"),
    ],
)
def test_the_list_finds_its_words(text: str, rule: str) -> None:
    assert RULES[rule].found(text)


@pytest.mark.parametrize(
    "text",
    [
        "a recommended depth",
        "an amended line",
        "outdoors",
        "the callback stands in a group",
        "What is missing?",
        "It says what is missing.",
        "Both stay the same.",
    ],
)
def test_the_list_leaves_other_words_alone(text: str) -> None:
    assert not list(complaints([Passage("x", 1, text)]))


def test_a_sentence_of_too_many_words_is_named_with_its_place() -> None:
    fits, long = "one " * (MOST_WORDS - 1) + "more.", "One " * MOST_WORDS + "more."
    assert list(complaints([Passage("x", 7, f"{fits} {long}")])) == [f"x:7: 26 words, 25 at most: {long}"]
    assert [rule for rule, _, _ in broken_rules(Passage("x", 7, long))] == [LONG_SENTENCE]


def test_each_kind_of_text_is_read() -> None:
    for patterns, passages in (*SOURCES, *EXPLANATIONS):
        read = [passage for path in paths(patterns) for passage in passages(path)]
        assert len(read) > 50, patterns


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


def test_strings_of_code_are_read_with_values_and_without_docstrings(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tests.language.texts.ROOT", tmp_path)
    module = tmp_path / "module.py"
    module.write_text('"""Judge the log of the program."""\n\nTEXT = f"the words {WORDS!r} in the log"\n')
    assert [passage.text for passage in string_passages(module)] == ["the words 5 in the log"]


def test_words_of_catalogs_are_read_with_values_and_their_forms_for_many() -> None:
    source = ROOT / "exercises" / "criteria" / "01_the_context.toml"
    texts = [passage.text for passage in catalog_passages(source)]
    assert "The program creates more nodes than it needs." in texts
    assert "5 lines in the log, but none in the last 5 s before Ctrl-C" in texts


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
    assert length("one " * MOST_WORDS) == MOST_WORDS


def test_every_docstring_of_a_function_begins_with_a_verb() -> None:
    found = all_without_verbs()
    assert not found, "\n".join(found)


@pytest.mark.parametrize("word", ["The", "Whether", "Raises", "name"])
def test_a_description_is_no_verb(word: str) -> None:
    assert not is_verb(word)


@pytest.mark.parametrize("word", ["Return", "Pass", "Process", "Yield"])
def test_an_imperative_is_a_verb(word: str) -> None:
    assert is_verb(word)


def test_docstrings_and_comments_are_read_as_paragraphs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tests.language.texts.ROOT", tmp_path)
    module = tmp_path / "module.py"
    module.write_text(
        '"""Judge a program."""\n\n# One reason\n# in two lines.\nX = 1  # a unit\n# noqa: E501\n'
        'def f():\n    """Return one.\n\n    It is small.\n    """\n'
    )
    found = [passage.text for passage in comment_passages(module)]
    assert sorted(found) == [
        "It is small.",
        "Judge a program.",
        "One reason in two lines.",
        "Return one.",
        "a unit",
    ]


def test_words_of_templates_are_read_without_tags(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tests.language.texts.ROOT", tmp_path)
    page = tmp_path / "page.html.j2"
    page.write_text(
        "<style>\n.beside{top:0}\n</style>\n{# a note of ours #}\n<p>You earned {{ points }} <b>points</b> today.</p>\n"
    )
    found = [(passage.line, passage.text) for passage in template_passages(page)]
    assert found == [(5, "You earned 5 points today.")]
