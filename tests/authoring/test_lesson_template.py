"""The structure of a lesson: a message names each missing part."""

from pathlib import Path

import pytest

from workbook.authoring.building import is_current
from workbook.authoring.document import Cell, with_ids
from workbook.authoring.lesson import read_lesson
from workbook.authoring.template import SHAPE, shape_violations
from workbook.authoring.tree import AuthoringError, Tree
from workbook.exercise.course import course_folder
from workbook.exercise.source import DEEPER

LESSON = Path(__file__).with_name("lesson_text.txt").read_text(encoding="utf-8")


def lesson(folder: Path, text: str) -> Tree:
    tree = Tree(folder)
    tree.sources.mkdir(parents=True)
    (tree.sources / "21_beeps.py").write_text(text, encoding="utf-8")
    return tree


def violations(folder: Path, text: str) -> list[str]:
    cells = read_lesson(lesson(folder, text), "21_beeps").cells
    return [words for _, words in shape_violations(cells, 21, has_exercise=True)]


def test_a_violation_names_the_line_of_its_section(tmp_path: Path) -> None:
    text = LESSON.replace("# - Five\n", "", 1)
    cells = read_lesson(lesson(tmp_path, text), "21_beeps").cells
    [(line, _)] = shape_violations(cells, 21, has_exercise=True)
    assert text.splitlines()[line - 1 : line + 1] == ["# %% [markdown]", "# ## Take away"]


def test_a_whole_lesson_has_no_problems(tmp_path: Path) -> None:
    assert violations(tmp_path, LESSON) == []


CASES = [
    ("# # 21 · Beeps", "# # Beeps", "must begin with the title, '# 21 · Timers'"),
    ("# A robot that backs up must be heard.\n", "", "one sentence of why"),
    ("# - **Minutes:** 20\n", "", "needs the line '- **Minutes:** …'"),
    ("**Minutes:** 20", "**Minutes:** about 20", "must be a number, not 'about 20'"),
    ("# - **Not covered:** loudness\n", "", "needs the line '- **Not covered:** …'"),
    ('predict("half-a-second")', "print()", "## Predict: needs a code cell in which the student chooses, predict('"),
    ("# ## Look inside", "# ## Look in", "the section '## Look inside' is missing"),
    ("# ## Look inside", "# ## Look in", "'## Look in' is not a section of a lesson"),
    ("# ## Look inside", "# Hello\n#\n# ## Look inside", "'## Look inside' must be the first line of a cell"),
    ("# ## Look inside", "# ## Run it", "'## Run it' is there more than once"),
    (". A period of half a second gives two beeps in each second, and so on.", "", "at least 30 words, it has 27"),
    ("# ### Slower", "# Slower", "two or three experiments, each under a '### ' heading; it has 1"),
    ('predict("faster")\n', "print()\n", "the experiment 'Faster' needs its own prediction"),
    ('\n\n# %%\nprint(1 / 0.1)\nreveal("faster")', "", "'Faster' needs a code cell after the prediction"),
    ('# %% tags=["raises-exception"] id="no-period"\n1 / 0\n', "", "provokes the error"),
    ("\n# %% [markdown]\n# A period of zero has no rate.\n", "", "must explain, after the code"),
    ("period = ...", "period = 1", "leaves something blank"),
    ("# First all of it, then with a blank, then [the exercise](../exercises/21_beeps.ipynb).", "# Now.", "must link"),
    ("# **3. And for 1 s?**\n", "", "needs three to five questions"),
    ("**3. And", "**4. And", "must be numbered from 1 on, not [1, 2, 4]"),
    ("✓ Yes: ten beeps", "Yes: ten beeps", "question 2, option 'a) 10 Hz': the explanation must begin with ✓ or ✗"),
    ("✗ No, that would be a minute.", "✗ No.", "question 3, option 'b) 60 Hz' needs an explanation"),
    ("✗ No, that would be", "✓ No, that would be", "question 3 needs exactly one option with ✓, but has 2"),
    ("Hz</summary>\n#\n# ✗ No, that is its inverse.\n#\n", "Hz</summary>\n# ✗ No, not at all.\n", "empty line"),
    ("# ```text\n# Would you", "# Would you", "needs the prompt, as a block that can be copied"),
    ("# - **Missed ticks come later:**", "# - Missed ticks come later:", "two wrong claims, each as"),
    ("What a good answer covers", "Answer", "What a good answer covers"),
    ("# - Five\n", "", "exactly five lines that begin with '- ', it has 4"),
    ("# **Next:** none yet; this is the last lesson.\n", "", "needs the line '**Next:** …'"),
    ("https://docs.ros.org/en/jazzy/", "https://example.org/", "official documentation"),
    ("print(1 / 2.0)", "# !pip install beep\nprint(1 / 2.0)", "no set-up cell"),
    ("<summary>a) 10 Hz</summary>", "<summary>a) `10` Hz</summary>", "'a) `10` Hz' is shown as it is written"),
    ("<summary>a) 10 Hz</summary>", "<summary>a) *10* Hz</summary>", "'a) *10* Hz' is shown as it is written"),
]  # fmt: skip


@pytest.mark.parametrize(
    "summary", ["a) <code>10</code> Hz", "a) 2 * 5 Hz, or 10 * 1 Hz", "a) 2*5 Hz and 10*1 Hz"]
)
def test_html_and_products_may_stand_in_a_summary(tmp_path: Path, summary: str) -> None:
    assert violations(tmp_path, LESSON.replace("a) 10 Hz</summary>", f"{summary}</summary>", 1)) == []


@pytest.mark.parametrize(("old", "new", "says"), CASES)
def test_a_fault_is_named(tmp_path: Path, old: str, new: str, says: str) -> None:
    assert old in LESSON
    found = violations(tmp_path, LESSON.replace(old, new, 1))
    assert any(says in words for words in found), found


def test_the_order_of_sections_counts(tmp_path: Path) -> None:
    text = (
        LESSON.replace("## Run it", "## X")
        .replace("## Look inside", "## Run it")
        .replace("## X", "## Look inside")
    )
    assert any("must come in this order: Predict, Run it" in words for words in violations(tmp_path, text))


def test_headings_inside_code_blocks_are_no_headings(tmp_path: Path) -> None:
    fence = "# ```text\n# ## not a section\n# ### nor an experiment\n# ```\n"
    assert violations(tmp_path, LESSON.replace("# The period is", fence + "# The period is", 1)) == []


def test_a_lesson_without_an_exercise_needs_no_link(tmp_path: Path) -> None:
    text = LESSON.replace("then [the exercise](../exercises/21_beeps.ipynb)", "and on")
    cells = read_lesson(lesson(tmp_path, text), "21_beeps").cells
    assert list(shape_violations(cells, 21, has_exercise=False)) == []
    assert list(shape_violations(cells, 21, has_exercise=True)) != []


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('tags=["raises-exception"]', 'tags=["raise-exception"]', "unknown tag 'raise-exception'"),
        ('tags=["raises-exception"]', 'tags=["nbval-skip"]', "unknown tag 'nbval-skip'"),
        (
            'id="no-period"',
            'slideshow={"slide_type": "slide"}',
            "prediction may be set, not slideshow",
        ),
        ('id="no-period"', 'id="no period"', "may have letters, digits"),
        ('id="no-period"', 'id="predict-1"', "'predict-1' is used twice"),
        ("# A period of zero has no rate.\n", "", "this cell is empty"),
    ],
)
def test_what_a_lesson_cannot_have_is_refused(tmp_path: Path, old: str, new: str, says: str) -> None:
    assert old in LESSON
    with pytest.raises(AuthoringError, match=r"notebooks/sources/21_beeps\.py") as caught:
        read_lesson(lesson(tmp_path, LESSON.replace(old, new, 1)), "21_beeps")
    assert says in str(caught.value)


def test_ids_tell_the_section_and_stay_when_another_section_grows() -> None:
    before = [
        Cell("markdown", "# 01"),
        Cell("markdown", "## Run it"),
        Cell("code", "1"),
        Cell("markdown", "## Take away"),
    ]
    after = [*before[:3], Cell("code", "2"), before[3]]
    assert [cell.id for cell in with_ids(before)] == ["intro-1", "run-it-1", "run-it-2", "take-away-1"]
    assert [cell.id for cell in with_ids(after)] == [
        "intro-1",
        "run-it-1",
        "run-it-2",
        "run-it-3",
        "take-away-1",
    ]


def test_our_own_lessons_have_the_shape() -> None:
    tree = Tree(course_folder())
    exercises = {stem[:2] for stem in tree.exercise_stems()}
    found = {
        stem: list(
            shape_violations(
                read_lesson(tree, stem).cells,
                int(stem[:2]),
                has_exercise=stem[:2] in exercises and not stem.endswith(DEEPER),
                is_deeper=stem.endswith(DEEPER),
            )
        )
        for stem in tree.lesson_stems()
    }
    assert {stem: words for stem, words in found.items() if words} == {}


def test_the_sections_are_those_of_the_curriculum() -> None:
    assert next(iter(SHAPE)) == "Predict"
    assert list(SHAPE)[-1] == "Take away"
    assert len(SHAPE) == 9


def test_a_notebook_that_was_not_run_is_not_current(tmp_path: Path) -> None:
    from workbook.authoring.document import as_notebook, to_text

    tree = lesson(tmp_path, LESSON)
    wanted = as_notebook(read_lesson(tree, "21_beeps"))
    path = tree.notebooks / "21_beeps.ipynb"
    path.write_text(to_text(wanted), encoding="utf-8")
    assert not is_current(path, wanted)
    path.write_text("not a notebook", encoding="utf-8")
    assert not is_current(path, wanted)
