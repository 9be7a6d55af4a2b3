"""The check finds and names every kind of error in notebooks and files."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import workbook.criteria
from workbook.authoring import __main__ as command
from workbook.authoring.checking import check
from workbook.authoring.lesson_links import write_links
from workbook.authoring.pages import write_pages
from workbook.authoring.tree import Tree
from workbook.authoring.violations import report
from workbook.authoring.vocabulary_list import first_line
from workbook.lesson import about

Notebook = dict[str, Any]


def problems(tree: Tree) -> list[str]:
    return [str(problem) for problem in check(tree)]


def change(path: Path, old: str, new: str) -> None:
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")


def change_notebook(path: Path, edit: Callable[[Notebook], None]) -> None:
    notebook = json.loads(path.read_text(encoding="utf-8"))
    edit(notebook)
    path.write_text(json.dumps(notebook), encoding="utf-8")


def cell(notebook: Notebook, name: str) -> Notebook:
    found: Notebook = next(one for one in notebook["cells"] if one["id"] == name)
    return found


def test_a_built_course_has_no_problems(built_once: Tree) -> None:
    assert problems(built_once) == []


def test_the_command_says_so_and_fails_otherwise(course: Tree, capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["--course", str(course.root), "check"]
    assert command.main(arguments) == 0
    said = capsys.readouterr().out
    assert said.startswith("1 lessons and 1 exercises: all match their texts.\n")
    assert "lines still come from a template: `make notebooks-check ARGS=--notes` lists them" in said
    assert command.main([*arguments, "--notes"]) == 0
    assert "solutions/21_beeps.py:17: is still the template's text: Your humanoid" in capsys.readouterr().out
    (course.notebooks / "notes.txt").touch()
    assert command.main(arguments) == 1
    found = capsys.readouterr()
    assert found.out.startswith(
        "notebooks/notes.txt: does not belong here: notebooks/ holds NN_slug.ipynb only\n"
    )
    assert found.err == "\n1 to fix.\n"


def rename(notebook: Notebook) -> None:
    cell(notebook, "run-it-2")["id"] = "a1b2c3d4"


def edit_source(notebook: Notebook) -> None:
    cell(notebook, "run-it-2")["source"] = "print('boop')"


def edit_tags(notebook: Notebook) -> None:
    cell(notebook, "run-it-2")["metadata"]["tags"] = ["nbval-ignore-output"]


def add_timing(notebook: Notebook) -> None:
    cell(notebook, "run-it-2")["metadata"]["execution"] = {"iopub.status.busy": "2026-01-01"}


def add_cell(notebook: Notebook) -> None:
    notebook["cells"].append({"cell_type": "markdown", "id": "extra", "metadata": {}, "source": "Hello"})


def swap(notebook: Notebook) -> None:
    notebook["cells"].reverse()


def python_version(notebook: Notebook) -> None:
    notebook["metadata"]["language_info"]["version"] = "3.11.7"


def old_hash(notebook: Notebook) -> None:
    notebook["metadata"]["workbook"]["source_sha256"] = "0" * 64


def not_run(notebook: Notebook) -> None:
    cell(notebook, "run-it-2")["execution_count"] = None


def error_shown(notebook: Notebook) -> None:
    outputs = cell(notebook, "no-period")["outputs"]
    cell(notebook, "run-it-2")["outputs"] = outputs


def error_gone(notebook: Notebook) -> None:
    cell(notebook, "no-period")["outputs"] = []


def picture_without_words(notebook: Notebook) -> None:
    cell(notebook, "run-it-2")["outputs"][0]["data"]["text/plain"] = "<Figure size 640x480 with 1 Axes>"


def no_picture(notebook: Notebook) -> None:
    cell(notebook, "run-it-2")["outputs"] = []


def unusual_number(notebook: Notebook) -> None:
    text = about(81.0, "ms", between=(5, 60))
    outputs = [{"name": "stdout", "output_type": "stream", "text": f"{text}\n"}]
    cell(notebook, "run-it-2")["outputs"] += outputs


@pytest.mark.parametrize(
    ("edit", "says"),
    [
        (rename, "cell ids differ from the text (has a1b2c3d4; lacks run-it-2): run `make notebooks`"),
        (edit_source, "cell run-it-2 differs from the text"),
        (edit_tags, "cell run-it-2 has other tags than the text"),
        (add_timing, "cell run-it-2 has metadata that the text does not give"),
        (add_cell, "cell ids differ from the text (has extra)"),
        (swap, "cell ids differ from the text (other order)"),
        (python_version, "its metadata is not what the text gives"),
        (old_hash, "its outputs are older than its text or a lesson node that it runs"),
        (not_run, "was not run from top to bottom"),
        (error_shown, "cell run-it-2 shows an error without the tag raises-exception"),
        (error_gone, "cell no-period is tagged raises-exception, but raised none"),
        (picture_without_words, "cell run-it-2: its figure has no text/plain that says what it shows"),
        (no_picture, "shows no figure"),
        (unusual_number, "cell run-it-2 shows a number that is unusual on this machine"),
    ],
)
def test_a_notebook_that_differs_is_found(course: Tree, edit: Callable[[Notebook], None], says: str) -> None:
    change_notebook(course.notebooks / "21_beeps.ipynb", edit)
    assert any(
        words.startswith("notebooks/21_beeps.ipynb: ") and says in words for words in problems(course)
    ), problems(course)


def test_a_changed_text_makes_its_notebook_stale(course: Tree) -> None:
    change(course.sources / "21_beeps.py", "print(1 / 0.1)", "print(1 / 0.2)")
    assert problems(course) == [
        "notebooks/21_beeps.ipynb: cell change-it-3 differs from the text: run `make notebooks`",
        "notebooks/21_beeps.ipynb: its outputs are older than its text or a lesson node that it runs: "
        "run `make notebooks`",
    ]


def test_a_changed_exercise_makes_its_notebook_stale(course: Tree) -> None:
    change(course.solutions / "21_beeps.py", "# TODO 1: create", "# TODO 1: make")
    assert problems(course) == [
        "exercises/21_beeps.ipynb: cell your-program differs from the text: run `make notebooks`"
    ]


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("notebooks/scratch.ipynb", "does not belong here: notebooks/ holds NN_slug.ipynb only"),
        ("notebooks/22_lights.ipynb", "has no text: notebooks/sources/22_lights.py is missing"),
        ("notebooks/sources/readme.md", "does not belong here"),
        ("exercises/21_beeps.py", "does not belong here: exercises/ holds NN_slug.ipynb only"),
        ("exercises/22_lights.ipynb", "has no text: solutions/22_lights.py is missing"),
        ("exercises/criteria/22_lights.py", "has no text: solutions/22_lights.py is missing"),
        ("solutions/lights.py", "does not belong here: solutions/ holds NN_slug.py only"),
        ("tests/right_answers/22_lights/one.py", "tests/right_answers/22_lights: has no text"),
        (
            "tests/wrong_answers/lights.py",
            "does not belong here: tests/wrong_answers/ holds folders NN_slug only",
        ),
        ("tests/right_answers/21_beeps/notes.md", "does not belong here: answers are Python files"),
        ("notebooks/sources/21_again.py", "number 21 is taken by 21_again"),
    ],
)
def test_a_file_that_fits_nowhere_is_found(course: Tree, name: str, says: str) -> None:
    path = course.root / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.touch()
    assert any(says in words for words in problems(course)), problems(course)


@pytest.mark.parametrize("name", [".ipynb_checkpoints", "__pycache__", ".hidden"])
def test_what_tools_leave_is_ignored(course: Tree, name: str) -> None:
    (course.notebooks / name).mkdir()
    (course.solutions / name).mkdir()
    assert problems(course) == []


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("notebooks/21_beeps.ipynb", "is not built"),
        ("exercises/21_beeps.ipynb", "is not built"),
        (
            "exercises/criteria/21_beeps.py",
            "21_beeps has no criteria: exercises/criteria/21_beeps.py is missing",
        ),
        ("tests/right_answers/21_beeps/script.py", "has 2 right answers, but needs at least 3"),
        ("notebooks/sources/21_beeps.py", "no lesson 21 leads to this exercise"),
    ],
)
def test_a_missing_file_is_found(course: Tree, name: str, says: str) -> None:
    (course.root / name).unlink()
    assert any(says in words for words in problems(course)), problems(course)


def test_what_looks_like_a_link_in_code_is_none(course: Tree) -> None:
    code = "# `class Sends[Taken](Protocol)`\n#\n# ```python\n# nets[0](picture)\n# ```\n#\n"
    change(course.root / "notebooks/sources/21_beeps.py", "# A period of zero", f"{code}# A period of zero")
    assert not any("leads nowhere" in words for words in problems(course)), problems(course)


@pytest.mark.parametrize(
    ("name", "old", "new", "says"),
    [
        ("solutions/21_beeps.py", "# %% [hint]\n", "", "needs exactly three [hint] cells"),
        (
            "solutions/21_beeps.py",
            "About 20 minutes",
            "A while",
            "beeps.py:4: the story must say '20 minutes'",
        ),
        ("solutions/21_beeps.py", "difficulty 2 of 5", "easy", "the story must say 'difficulty 2 of 5'"),
        ("solutions/21_beeps.py", "10 points", "6 points", "the story must say '10 points'"),
        ("solutions/21_beeps.py", "# | 1 | the", "# | 2 | the", "add up to 10, not 11"),
        (
            "solutions/21_beeps.py",
            "# # Exercise 21 · ",
            "# # Beeps ",
            "the story must begin with '# Exercise 21 · ",
        ),
        (
            "exercises/criteria/21_beeps.py",
            "points=1",
            "points=2",
            "beeps.py:13: the points of all criteria must add up to 10, not 11",
        ),
        ("exercises/criteria/21_beeps.py", "import workbook", "import nothing", "No module named 'nothing'"),
        (
            "tests/wrong_answers/21_beeps/wrong_name.py",
            "# loses: ",
            "# costs: ",
            "wrong_name.py:2: unknown field 'costs'",
        ),
        (
            "notebooks/sources/21_beeps.py",
            "(../exercises/21_beeps",
            "(../exercises/21_boops",
            "leads nowhere",
        ),
        (
            "notebooks/sources/21_beeps.py",
            "# A period of zero",
            "# ![](dot.png) A",
            "has no alternative text",
        ),
        ("notebooks/sources/21_beeps.py", "print(1 / 0.1)", "# NBVAL_SKIP\nprint()", "write a tag instead"),
    ],
)
def test_a_fault_in_a_text_is_found(course: Tree, name: str, old: str, new: str, says: str) -> None:
    change(course.root / name, old, new)
    assert any(says in words for words in problems(course)), problems(course)


def test_more_than_a_third_ignored_is_too_much(course: Tree) -> None:
    source = course.sources / "21_beeps.py"
    text = source.read_text(encoding="utf-8")
    source.write_text(text.replace("# %%\n", '# %% tags=["nbval-ignore-output"]\n'), encoding="utf-8")
    assert any(
        "of 11 code cells ignore their output; at most a third may" in words for words in problems(course)
    )


def test_too_few_answers_are_named(course: Tree) -> None:
    for name in ("wrong_name", "no_timer", "six_seconds"):
        (course.wrong_answers / "21_beeps" / f"{name}.py").unlink()
    assert "tests/wrong_answers/21_beeps: has 4 wrong answers, but needs at least 5" in problems(course)


def test_a_criterion_that_does_not_exist_is_named(course: Tree) -> None:
    change(course.wrong_answers / "21_beeps" / "wrong_name.py", "# skips: twice_a_second", "# skips: twice")
    [words] = problems(course)
    assert words.startswith("tests/wrong_answers/21_beeps/wrong_name.py:3: there is no criterion 'twice'")


def test_at_least_four_criteria_earn_points(course: Tree) -> None:
    path = course.criteria / "21_beeps.py"
    for old, new in (("points=3", "points=5"), ('points=2, title="The temp', 'points=0, title="The temp')):
        change(path, old, new)
    change(path, "points=1", "points=0")
    change(path, "points=5", "points=6")
    assert any("3 criteria earn points, but at least 4 must" in words for words in problems(course))


def lights(course: Tree) -> Path:
    """Add a second lesson."""
    text = (
        (course.sources / "21_beeps.py")
        .read_text(encoding="utf-8")
        .replace("# # 21 · Beeps", "# # 22 · Lights")
    )
    path = course.sources / "22_lights.py"
    path.write_text(text, encoding="utf-8")
    return path


def test_links_to_the_neighbors_are_stale_until_they_are_built(course: Tree) -> None:
    path = lights(course)
    stale = "the **Before:**, **Deeper:** and **Next:** lines don't match the neighboring lessons: run `make notebooks`"
    assert [words for words in problems(course) if stale in words] == [
        f"notebooks/sources/21_beeps.py:185: {stale}",
        f"notebooks/sources/22_lights.py:185: {stale}",
    ]
    before = path.read_text(encoding="utf-8")
    assert write_links(course) == ["21_beeps", "22_lights"]
    assert "# **Next:** [22 · Lights](22_lights.ipynb)\n" in (course.sources / "21_beeps.py").read_text()
    last = "# **Next:** none yet"
    assert path.read_text() == before.replace(last, f"# **Before:** [21 · Beeps](21_beeps.ipynb)\n#\n{last}")
    assert write_links(course) == []
    path.unlink()
    write_links(course)
    assert check(course) == []


def test_words_around_the_link_stay_while_it_leads_to_the_same_lesson(course: Tree) -> None:
    path = lights(course)
    write_links(course)
    source = course.sources / "21_beeps.py"
    change(source, "(22_lights.ipynb)", "(22_lights.ipynb), which shine")
    change(path, "# # 22 · Lights", "# # 22 · Lamps")
    assert write_links(course) == ["21_beeps"]
    assert "# **Next:** [22 · Lamps](22_lights.ipynb), which shine\n" in source.read_text()
    path.rename(course.sources / "23_lights.py")
    write_links(course)
    assert "# **Next:** [22 · Lamps](23_lights.ipynb)\n" in source.read_text()


def test_you_need_names_earlier_lessons(course: Tree) -> None:
    change(
        course.sources / "21_beeps.py", "**You need:** Python", "**You need:** lesson [21](22_lights.ipynb)"
    )
    assert any("21_beeps.py:7: 'You need' links to earlier lessons" in words for words in problems(course))


def test_the_table_of_the_readme_and_the_vocabulary_are_generated(course: Tree) -> None:
    parts = {"README.md": "lessons", "docs/vocabulary.md": "vocabulary"}
    for name, part in parts.items():
        text = f"# Page\n\n<!-- {part}: made by `make notebooks` -->\n<!-- end of {part} -->\n\nEnd.\n"
        (course.root / name).parent.mkdir(exist_ok=True)
        (course.root / name).write_text(text, encoding="utf-8")
    (course.sources / "planned.toml").write_text('21 = "Written"\n22 = "Lights"\n', encoding="utf-8")
    stale = "is not what lessons and exercises say: run `make notebooks`"
    assert problems(course) == [f"README.md:4: {stale}", f"docs/vocabulary.md:4: {stale}"]
    write_pages(course)
    assert check(course) == []
    readme = (course.root / "README.md").read_text(encoding="utf-8")
    assert readme.endswith("\n\nPlanned: *Lights*.\n\n<!-- end of lessons -->\n\nEnd.\n")
    assert "| 21 | [Beeps](notebooks/21_beeps.ipynb) | [Beeps](exercises/21_beeps.ipynb) |" in readme
    words = (course.root / "docs/vocabulary.md").read_text(encoding="utf-8")
    assert "| `publishes(recording, topic)` | " in words
    (course.root / "README.md").write_text("# Page\n", encoding="utf-8")
    assert any(words.startswith("README.md: needs the lines '<!-- lessons:") for words in problems(course))


def test_each_word_of_the_vocabulary_says_what_it_is() -> None:
    empty = [name for name in workbook.criteria.__all__ if len(first_line(workbook.criteria, name)) < 15]
    assert empty == []


def test_the_report_names_a_violation_a_line(course: Tree) -> None:
    (course.notebooks / "21_beeps.ipynb").unlink()
    (course.solutions / "x.md").touch()
    assert report(check(course)).splitlines() == [
        "solutions/x.md: does not belong here: solutions/ holds NN_slug.py only",
        "notebooks/21_beeps.ipynb: is not built: run `make notebooks`",
    ]
