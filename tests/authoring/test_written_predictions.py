"""Predictions in a lesson's text: which parts go into the notebook, which are sealed, and which letters are right."""

import json
import re
from collections.abc import Sequence
from pathlib import Path

import pytest

from workbook.authoring import building
from workbook.authoring.building import build_lesson
from workbook.authoring.checking import check
from workbook.authoring.lesson import read_lesson
from workbook.authoring.letters import letter_violations, prediction_letters, question_letters
from workbook.authoring.predictions import prediction_violations, read_prediction
from workbook.authoring.tree import AuthoringError, Tree
from workbook.exercise.course import course_folder
from workbook.lesson.sealed_predictions import unseal

UNCONVERTED: tuple[str, ...] = ()
"""Lessons whose predictions are still typed words, with the key in a cell. This list may only shrink."""
OWN = Tree(course_folder())
OLD_FORM = re.compile(r"^\s*(?:predict\(.*about=|recall\(|predicted\()", re.MULTILINE)
LESSON = Path(__file__).with_name("lesson_text.txt").read_text(encoding="utf-8")

QUESTION = """## Predict

How many?

- **a** None, says `spin`,
  and goes on
  when `n == 0`
  ✗ It does not wait
  for anybody.
- **b** All
  when `0 < n <= 5`
  ✓ Each of them has its turn.
- **c** It depends
  ✗ On nothing that you see here.

One thread only."""


def test_the_notebook_gets_question_and_options_only() -> None:
    shown, prediction = read_prediction("how-many", QUESTION)
    assert shown.splitlines() == [
        "## Predict", "", "How many?", "", "- **a** None, says `spin`,", "  and goes on", "- **b** All",
        "- **c** It depends", "", "One thread only.",
    ]  # fmt: skip
    a, b, c = prediction.options
    assert (a.text, a.why) == ("None, says `spin`, and goes on", "It does not wait for anybody.")
    assert (a.when, b.when, c.when) == ("n == 0", "0 < n <= 5", "")
    assert (prediction.usual, prediction.letters) == ("b", "a, b or c")
    assert [prediction.decided_by({"n": n}) for n in (0, 3, 9)] == ["a", "b", None]


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("- **c** It depends\n  ✗ On nothing that you see here.\n", "", "at least 3 options"),
        ("- **c**", "- **d**", "from a on"),
        ("  ✗ On nothing that you see here.\n", "", "option c of 'how-many' needs an explanation"),
        ("✗ On nothing that you see here.", "✗ No.", "option c of 'how-many' needs an explanation"),
        ("✗ On", "✓ On", "exactly one option with ✓, but has 2"),
        ("  when `0 < n <= 5`\n", "", "the option with ✓ of 'how-many' needs a condition"),
        ("n == 0", "n ==", "is not a condition"),
        ("n == 0", "exit()", "may only compare names and numbers"),
        ("n == 0", "n.__class__ == 0", "may only compare names and numbers"),
        (
            "It depends\n",
            "It depends when `n > 5`\n",
            "option c of 'how-many': put the condition on a line by",
        ),
        ("Each of", "*Each* of", "option b of 'how-many': '*Each*' is shown as it is written"),
        (
            "for anybody.",
            "for *any\n  body*.",
            "option a of 'how-many': '*any body*' is shown as it is written",
        ),
        ("It depends", "It *depends*", "option c of 'how-many': '*depends*' is shown as it is written"),
    ],
)
def test_what_is_no_prediction_is_refused_in_words(old: str, new: str, says: str) -> None:
    assert old in QUESTION
    with pytest.raises(ValueError, match=r".") as caught:
        read_prediction("how-many", QUESTION.replace(old, new, 1))
    assert says in str(caught.value)


@pytest.mark.parametrize(
    "why", ["`*args*` takes **each** of them.", "2 * 3 and 3 * 2 are 6.", "2*3 and 3*2 are 6."]
)
def test_code_bold_words_and_products_may_stand_in_an_explanation(why: str) -> None:
    _, prediction = read_prediction("how-many", QUESTION.replace("Each of them has its turn.", why))
    assert prediction.option("b").why == why


def test_the_name_of_a_prediction_is_made_of_small_letters(course: Tree) -> None:
    path = course.sources / "21_beeps.py"
    path.write_text(LESSON.replace('prediction="slower"', 'prediction="Slower!"'), encoding="utf-8")
    with pytest.raises(
        AuthoringError, match=r"21_beeps\.py, cell \d+ \(### Slower\): a prediction is named in"
    ):
        read_lesson(course, "21_beeps")


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('predict("slower")', "print()", "the prediction 'slower' is never asked"),
        ('reveal("slower")', "print()", "the prediction 'slower' is never revealed"),
        ('predict("slower")', 'predict("slower", "c")', "the student chooses, write predict('slower') only"),
        ('predict("slower")', 'predict("slowly")', "no cell of this lesson has prediction='slowly'"),
        (
            'predict("half-a-second")',
            'predict("half-a-second")\nreveal("faster")',
            "before the student is asked",
        ),
    ],
)
def test_each_prediction_is_asked_and_then_revealed(course: Tree, old: str, new: str, says: str) -> None:
    assert list(prediction_violations(read_lesson(course, "21_beeps"))) == []
    assert old in LESSON
    (course.sources / "21_beeps.py").write_text(LESSON.replace(old, new, 1), encoding="utf-8")
    found = [words for _, words in prediction_violations(read_lesson(course, "21_beeps"))]
    assert any(says in words for words in found), found


def test_a_built_lesson_holds_the_outcomes_only_after_the_run(built_once: Tree) -> None:
    cells = json.loads((built_once.notebooks / "21_beeps.ipynb").read_text(encoding="utf-8"))["cells"]
    by_id = {cell["id"]: json.dumps(cell, ensure_ascii=False) for cell in cells}
    telling = [name for name, text in by_id.items() if "One over 4 s" in text]
    assert telling == ["change-it-7"]
    assert "The outcome is c." in by_id["change-it-7"]
    assert "The outcome is b." in by_id["change-it-7"]
    assert "Choose a, b or c" in by_id["predict-2"]


def test_what_is_sealed_belongs_to_the_text(course: Tree) -> None:
    path = course.sealed / "21_beeps.txt"
    names = [one.name for one in unseal(path.read_text(encoding="utf-8"))]
    assert names == ["half-a-second", "faster", "slower"]
    assert not any("predictions" in str(one) for one in check(course))
    path.write_text(path.read_text(encoding="utf-8")[:-40], encoding="utf-8")
    (course.sealed / "22_gone.txt").write_text("x", encoding="utf-8")
    found = [str(one) for one in check(course)]
    assert "workbook/lesson/sealed/22_gone.txt: belongs to no lesson: remove it" in found
    assert any(
        "21_beeps.txt: does not match the predictions in the text of the lesson" in one for one in found
    )


def test_another_explanation_is_sealed_and_shown_anew(course: Tree, monkeypatch: pytest.MonkeyPatch) -> None:
    path = course.sources / "21_beeps.py"
    path.write_text(LESSON.replace("One over 4 s is", "A quarter is"), encoding="utf-8")
    ran: list[str] = []
    monkeypatch.setattr(building, "run", lambda _tree, stem, _notebook: ran.append(stem))
    build_lesson(course, "21_beeps")
    assert ran == ["21_beeps"]
    told = unseal((course.sealed / "21_beeps.txt").read_text(encoding="utf-8"))
    assert told[2].options[2].why == "A quarter is 0.25 Hz."


def test_names_are_used_once_in_the_course(course: Tree) -> None:
    (course.sources / "22_boops.py").write_text(LESSON.replace("21 · Beeps", "22 · Boops"), encoding="utf-8")
    (course.sealed / "22_boops.txt").write_text(
        (course.sealed / "21_beeps.txt").read_text(encoding="utf-8"), encoding="utf-8"
    )
    assert any("the prediction 'slower' is also one of 21_beeps" in str(one) for one in check(course))


def questions(letters: Sequence[str]) -> str:
    """Make questions whose right options have these letters."""
    lines = []
    for right in letters:
        for letter in "abc":
            sign = "✓" if letter == right else "✗"
            lines.append(
                f"# <details><summary>{letter}) so</summary>\n#\n# {sign} because of that\n#\n# </details>"
            )
    return "\n".join(lines)


@pytest.mark.parametrize(
    ("lessons", "says"),
    [
        (("aaab", "bcbc"), ["a is right in 3 of 4 questions; at most 60% are allowed"]),
        (("aaa", "bcbc"), []),
        (("aabc" * 3, "abbc" * 2), []),
        (
            ("aabbc" * 2, "aabbb" * 2),
            ["in the course, b is right in 10 of 20 questions; at most 40% are allowed"],
        ),
    ],
)
def test_a_letter_that_is_right_too_often_is_told(
    tmp_path: Path, lessons: tuple[str, ...], says: list[str]
) -> None:
    tree = Tree(tmp_path)
    tree.sources.mkdir(parents=True)
    for number, letters in enumerate(lessons):
        (tree.sources / f"{number:02d}_one.py").write_text(f"# %% [markdown]\n{questions(letters)}\n")
    assert list(question_letters(tree).values()) == [list(letters) for letters in lessons]
    assert [one.words for one in letter_violations(tree)] == says


def test_our_own_letters_are_balanced() -> None:
    assert [str(one) for one in letter_violations(OWN)] == []
    assert sum(len(letters) for letters in question_letters(OWN).values()) >= 61
    assert sum(len(letters) for letters in prediction_letters(OWN).values()) >= 57


def test_all_lessons_but_the_named_ones_are_converted() -> None:
    old = [
        stem
        for stem in OWN.lesson_stems()
        if OLD_FORM.search((OWN.sources / f"{stem}.py").read_text(encoding="utf-8"))
    ]
    assert old == list(UNCONVERTED)


def test_no_notebook_tells_before_the_run_what_a_prediction_reveals() -> None:
    """Check sources and outputs up to the cell that reveals the outcome.

    No cell's source may contain the explanations.
    """
    for stem in OWN.lesson_stems():
        predictions = {one.name: one for one in read_lesson(OWN, stem).predictions}
        cells = json.loads((OWN.notebooks / f"{stem}.ipynb").read_text(encoding="utf-8"))["cells"]
        sources = "\n".join("".join(cell["source"]) for cell in cells)
        open_ones = dict(predictions)
        for one in predictions.values():
            for option in one.options:
                assert option.why not in " ".join(sources.split()), f"{stem}: {one.name}"
                # A condition that is only a name may occur in a cell, which measures it. A comparison doesn't occur in
                # any cell.
                assert not option.when or option.when.isidentifier() or option.when not in sources
        for cell in cells:
            for name in re.findall(r'reveal\(\s*"([a-z0-9-]+)"', "".join(cell["source"])):
                open_ones.pop(name, None)
            shown = json.dumps(cell.get("outputs", []), ensure_ascii=False)
            for one in open_ones.values():
                assert not any(option.why in shown for option in one.options), f"{stem}: {cell['id']}"
