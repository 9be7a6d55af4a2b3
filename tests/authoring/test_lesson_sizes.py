"""The size of a lesson: words, cells, minutes, their limits, and the optional notebooks for what exceeds them."""

from pathlib import Path

import pytest

from workbook.authoring.checking import check
from workbook.authoring.lesson import read_lesson
from workbook.authoring.lesson_links import write_links
from workbook.authoring.lesson_lists import list_page, table
from workbook.authoring.size import (
    LIMITS,
    TOO_LARGE,
    Size,
    minutes_in,
    size_of,
    size_violations,
    still_too_large,
    words,
    write_sizes,
)
from workbook.authoring.tree import Tree
from workbook.exercise.course import course_folder

LESSON = Path(__file__).with_name("lesson_text.txt").read_text(encoding="utf-8")
DEEPER = """# %% [markdown]
# # 21 · Deeper: the length of a beep
#
# A robot that backs up must be heard.
#
# - **Minutes:** 1
# - **You need:** lesson [21](21_beeps.ipynb)
# - **You will be able to:** say how long a beep is
# - **Not covered:** loudness

# %% [markdown] prediction="long-beep"
# ## Predict
#
# - **a** It is long.
#   ✗ It is not that long.
# - **b** It is short.
#   ✓ It is as short as can be.
# - **c** It never ends.
#   ✗ Each beep ends at last.

# %%
from workbook.lesson import predict, reveal

predict("long-beep")

# %% [markdown]
# ## Run it

# %%
reveal("long-beep")

# %% [markdown]
# ## Look inside
#
# One two three four five six seven eight nine ten. One two three four five six seven eight nine ten. One two three four
# five six seven eight nine ten.

# %% [markdown]
# ## Take away
#
# - A beep is short.
#
# **Next:** somewhere
#
# **More:** [Time](https://docs.ros.org/en/jazzy/)
"""


def course_with(folder: Path, **lessons: str) -> Tree:
    tree = Tree(folder)
    tree.sources.mkdir(parents=True)
    for stem, text in lessons.items():
        (tree.sources / f"{stem.removeprefix('at_')}.py").write_text(text, encoding="utf-8")
    return tree


def violations(tree: Tree, stem: str = "21_beeps") -> list[str]:
    text = (tree.sources / f"{stem}.py").read_text(encoding="utf-8")
    return [said for _, said in size_violations(tree, stem, text, read_lesson(tree, stem))]


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("A timer fires.", 3),
        ("a · b — 2 Hz", 4),
        ("[the lesson](../notebooks/a_b.ipynb)", 2),
        ("<details><summary>a) Yes</summary>", 2),
        ("", 0),
    ],
)
def test_words_are_what_is_read(text: str, number: int) -> None:
    assert words(text) == number


def test_minutes_are_reading_running_and_answering() -> None:
    assert Size(open_words=1700, fold_words=100, cells=50, runs=20, asked=10).minutes == 40
    assert Size(open_words=1701, fold_words=100, cells=50, runs=20, asked=10).minutes == 45


def test_the_parts_of_a_lesson_are_told_apart(tmp_path: Path) -> None:
    size = size_of(read_lesson(course_with(tmp_path, at_21_beeps_deeper=DEEPER), "21_beeps_deeper"))
    assert (size.cells, size.runs, size.asked) == (7, 1, 1)
    assert size.fold_words == 5 + 7 + 5  # the explanations of the options


def test_code_and_folds_are_no_open_text(tmp_path: Path) -> None:
    plain = size_of(read_lesson(course_with(tmp_path / "a", at_21_beeps=LESSON), "21_beeps"))
    more = LESSON.replace(
        "# ## Run it\n",
        "# ## Run it\n#\n# ```python\n# beep = 1\n# ```\n#\n#     workbook graph\n#\n"
        "# <details><summary>Why</summary>\n#\n# Two words.\n#\n# </details>\n",
        1,
    )
    with_fold = size_of(read_lesson(course_with(tmp_path / "b", at_21_beeps=more), "21_beeps"))
    assert with_fold.open_words == plain.open_words
    assert with_fold.fold_words == plain.fold_words + 3


def test_the_build_puts_minutes_right_and_the_check_names_wrong_ones(tmp_path: Path) -> None:
    tree = course_with(tmp_path, at_21_beeps=LESSON.replace("**Minutes:** 20", "**Minutes:** 55"))
    assert violations(tree) == [f"takes {size_of(read_lesson(tree, '21_beeps')).minutes} minutes "
                          "according to its size, but says 55: run `make notebooks`"]  # fmt: skip
    assert write_sizes(tree) == ["21_beeps"]
    assert violations(tree) == []
    assert write_sizes(tree) == []


def test_what_is_too_large_is_named_and_may_only_shrink(tmp_path: Path) -> None:
    long = LESSON.replace("# ## Run it\n", "# ## Run it\n#\n# " + "beep " * 2_500 + "\n", 1)
    tree = course_with(tmp_path, at_21_beeps=long)
    write_sizes(tree)
    [words_of_it] = violations(tree)
    assert words_of_it.endswith(
        "open words, but at most 2000 are allowed: cut, or move a part to 21_beeps_deeper"
    )
    assert not (tree.sources / TOO_LARGE).exists()

    (tree.sources / TOO_LARGE).write_text('[21_beeps]\n"open words" = 9000\n', encoding="utf-8")
    assert violations(tree) == []
    write_sizes(tree)
    kept = still_too_large(tree)["21_beeps"]["open words"]
    assert 2_500 < kept < 2_800
    assert violations(tree) == []
    (tree.sources / "21_beeps.py").write_text(long.replace("# beep ", "# beep beep ", 1), encoding="utf-8")
    write_sizes(tree)
    assert still_too_large(tree)["21_beeps"]["open words"] == kept
    assert violations(tree) == [
        f"{kept + 1} open words, but at most {kept} are allowed: cut, or move a part to 21_beeps_deeper"
    ]


def test_a_deeper_notebook_comes_after_its_lesson_and_leads_to_the_next(tmp_path: Path) -> None:
    later = LESSON.replace("21 · Beeps", "22 · Horns")
    tree = course_with(tmp_path, at_21_beeps=LESSON, at_21_beeps_deeper=DEEPER, at_22_horns=later)
    write_links(tree)
    text = {stem: (tree.sources / f"{stem}.py").read_text(encoding="utf-8") for stem in tree.lesson_stems()}
    deeper = "[21 · Deeper: the length of a beep](21_beeps_deeper.ipynb)"
    assert f"# **Deeper:** {deeper}\n#\n# **Next:** [22 · Horns]" in text["21_beeps"]
    assert (
        "# **Before:** [21 · Beeps](21_beeps.ipynb)\n#\n# **Next:** [22 · Horns]" in text["21_beeps_deeper"]
    )
    assert "# **Before:** [21 · Beeps](21_beeps.ipynb)\n" in text["22_horns"]
    assert write_links(tree) == []


def test_a_deeper_notebook_is_listed_with_its_lesson(tmp_path: Path) -> None:
    tree = course_with(tmp_path, at_21_beeps=LESSON, at_21_beeps_deeper=DEEPER)
    assert table(tree).splitlines()[2:] == [
        "| 21 | [Beeps](notebooks/21_beeps.ipynb) · [deeper](notebooks/21_beeps_deeper.ipynb) "
        "| in the lesson, not graded |",
    ]
    assert list_page(tree).index("21_beeps.ipynb") < list_page(tree).index("21_beeps_deeper.ipynb")


def test_a_deeper_notebook_may_leave_out_sections(tmp_path: Path) -> None:
    tree = course_with(tmp_path, at_21_beeps=LESSON, at_21_beeps_deeper=DEEPER)
    write_links(tree)
    write_sizes(tree)
    path = "notebooks/sources/21_beeps_deeper.py"
    assert [one.words for one in check(tree) if one.where == path] == []
    (tree.sources / "21_beeps_deeper.py").write_text(DEEPER.replace("Deeper: the", "The"), encoding="utf-8")
    found = [one.words for one in check(tree) if one.where == path]
    assert any("must begin with the title, '# 21 · Deeper: " in said for said in found)


def test_a_deeper_notebook_without_its_lesson_is_misplaced(tmp_path: Path) -> None:
    tree = course_with(tmp_path, at_21_beeps_deeper=DEEPER)
    assert any("goes with the lesson of the same name" in one.words for one in check(tree))


def test_our_own_lessons_keep_to_the_limits() -> None:
    tree = Tree(course_folder())
    found = {stem: violations(tree, stem) for stem in tree.lesson_stems()}
    assert {stem: said for stem, said in found.items() if said} == {}
    assert all(minutes_in((tree.sources / f"{stem}.py").read_text(encoding="utf-8")) for stem in found)


def test_what_is_kept_is_over_the_limits() -> None:
    tree = Tree(course_folder())
    for stem, over in still_too_large(tree).items():
        assert over == size_of(read_lesson(tree, stem)).over, f"{stem}: run `make notebooks`"
        assert all(number > LIMITS[name] for name, number in over.items())
