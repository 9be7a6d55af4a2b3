"""The format of an exercise source, and the messages to authors who break it."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbook.exercise.source import SourceError, UnknownExercise, find, load, split_answer, stems

GOOD = '''\
# ---
# exercise: 21_wave_hello
# title: Wave hello
# minutes: 15
# difficulty: 2
# kind: program
# clock: simulated
# objectives: [publish a wave, keep a rate]
# out_of_scope:
#   - inverse kinematics
# ---
# %% [markdown]
# # Exercise 21 · Wave hello
#
# The robot greets you.
# %% [markdown]
# | topic | rate |
# |---|---|
# | `/robot/wave` | 2 Hz |
# %% [answer]
"""A node that waves."""

import math


def angle(t: float) -> float:
    # [solution]
    return math.sin(t)
    # [starter]
    # | # TODO 1: swing between -1 and 1
    # |
    # | if t > 0:
    # |     return 0.0
    # | return 0.0
    # [end]


# [solution]
print(angle(0.5))
# [end]
# %% [hint]
# Think of a swing.
# %% [hint]
# `math.sin` swings.
# %% [hint]
# ```python
# return math.sin(...)
# ```
# %% [alternatives]
# A table of angles does it as well.
# %% [markdown]
# Then shake hands.
'''


def write(folder: Path, text: str, name: str = "21_wave_hello.py") -> Path:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def test_everything_is_read(tmp_path: Path) -> None:
    source = load(write(tmp_path, GOOD))
    assert (source.stem, source.number, source.slug) == ("21_wave_hello", 21, "wave_hello")
    assert (source.title, source.minutes, source.difficulty) == ("Wave hello", 15, 2)
    assert (source.kind, source.clock) == ("program", "simulated")
    assert source.objectives == ("publish a wave", "keep a rate")
    assert source.out_of_scope == ("inverse kinematics",)
    assert source.story[0] == "# Exercise 21 · Wave hello\n\nThe robot greets you."
    assert source.story[1].splitlines()[0] == "| topic | rate |"
    assert source.afterword == ("Then shake hands.",)
    assert source.live == "%start"
    assert source.hints[2] == "```python\nreturn math.sin(...)\n```"
    assert source.alternatives.startswith("A table")


def test_solution_and_starter_differ_only_in_marked_parts(tmp_path: Path) -> None:
    source = load(write(tmp_path, GOOD))
    shared_head = '"""A node that waves."""\n\nimport math\n\n\ndef angle(t: float) -> float:\n'
    assert source.solution_code == shared_head + "    return math.sin(t)\n\n\nprint(angle(0.5))\n"
    assert source.starter_code == (
        shared_head
        + "    # TODO 1: swing between -1 and 1\n\n    if t > 0:\n        return 0.0\n    return 0.0\n\n\n"
    )


def test_the_source_is_the_reference_program(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    exec(compile(write(tmp_path, GOOD).read_text(encoding="utf-8"), "answer", "exec"), {})
    assert capsys.readouterr().out == "0.479425538604203\n"


def test_a_live_cell_replaces_the_default(tmp_path: Path) -> None:
    live = "# %% [live]\n# from somewhere import figure\n# figure()\n# %% [hint]\n# Think"
    source = load(write(tmp_path, GOOD.replace("# %% [hint]\n# Think", live, 1)))
    assert source.live == "from somewhere import figure\nfigure()"


@pytest.mark.parametrize(
    ("old", "new", "line", "says"),
    [
        ("# ---\n# exercise", "# exercise", 1, "begin with a header"),
        ("# title: Wave hello\n", "", 10, "the header lacks title"),
        ("# title: Wave hello", "# titel: Wave hello", 3, "unknown header field 'titel'"),
        ("# title: Wave hello", "# title: 'Wave", 3, "not valid YAML"),
        ("# title: Wave hello", "# minutes: 3", 4, "'minutes' twice"),
        ("exercise: 21_wave_hello", "exercise: 20_wave", 2, "the file is called 21_wave_hello.py"),
        ("minutes: 15", "minutes: soon", 4, "minutes must be a whole number"),
        ("difficulty: 2", "difficulty: 6", 5, "from 1 to 5, not 6"),
        ("kind: program", "kind: essay", 6, "kind must be one of program, function, test, static"),
        ("clock: simulated", "clock: robot", 7, "clock must be one of simulated, wall"),
        ("objectives: [publish a wave, keep a rate]", "objectives: []", 8, "objectives must be a list"),
        ("# # Exercise 21 · Wave hello", "# Exercise 21", 20, "a '# title'"),
        ("# The robot greets you.", "The robot greets you.", 15, "must begin with '# '"),
        ("# %% [markdown]\n# # Ex", "hello()\n# %% [markdown]\n# # Ex", 12, "before the first '# %%' cell"),
        ("# %% [answer]", "# %% [anwser]", 20, "unknown cell '# %% [anwser]'"),
        ("# %% [answer]", "# %%", 20, "unknown cell '# %%'"),
        ("# %% [answer]", "# %% [alternatives]", 1, "exactly one '# %% [answer]' cell, found 0"),
        ("# %% [hint]\n# Think of a swing.\n", "", 50, "[hint] cells (nudge, pointer, sketch), found 2"),
        ("# Think of a swing.", "# Think.\n# %% [hint]\n# Once more.", 47, "found 4"),
        ("# Think of a swing.\n", "", 41, "this [hint] cell is empty"),
        ("# %% [alternatives]\n# A table of angles does it as well.\n", "", 50, "exactly one [alternatives]"),
        ("    # [starter]\n", "    # [begin]\n", 29, "unknown marker [begin]"),
        ("    # [solution]\n", "", 28, "[starter] without a [solution]"),
        ("    # [end]\n", "    # [solution]\n    # [end]\n", 35, "inside the part that line 27 opened"),
        ("print(angle(0.5))\n# [end]", "print(angle(0.5))", 38, "has no [end]"),
        ("\n# [solution]\nprint", "\nprint", 39, "[end] without a [solution]"),
        ("    # | return 0.0", "    return 0.0", 34, "a starter line must look like"),
        ("    # | if t > 0:", "    # | if t > 0", 32, "the starter is not valid Python"),
        ("return math.sin(t)", "return math.sin(t", 28, "the solution is not valid Python"),
    ],
)  # fmt: skip
def test_a_mistake_is_named_with_its_line(tmp_path: Path, old: str, new: str, line: int, says: str) -> None:
    assert GOOD.count(old) >= 1
    path = write(tmp_path, GOOD.replace(old, new, 1))
    with pytest.raises(SourceError) as caught:
        load(path)
    assert says in str(caught.value)
    assert str(caught.value).startswith(f"{path}:{line}: ")
    assert (caught.value.path, caught.value.line) == (path, line)


def test_an_answer_without_marked_parts_is_refused(tmp_path: Path) -> None:
    head, answer = GOOD.split("# %% [answer]\n")
    tail = answer[answer.index("# %% [hint]") :]
    with pytest.raises(SourceError, match="gives everything away"):
        load(write(tmp_path, head + "# %% [answer]\nprint('hello')\n" + tail))


def test_a_name_that_is_no_stem_is_refused(tmp_path: Path) -> None:
    with pytest.raises(SourceError, match="the file name must look like"):
        load(write(tmp_path, GOOD, "wave.py"))


@pytest.mark.parametrize(
    "name", ["05_timers", "timers", "05", "5", "05_timers.py", "work/exercises/05_timers.ipynb"]
)
def test_an_exercise_is_found_by_each_of_its_names(tmp_path: Path, name: str) -> None:
    for file in ("05_timers.py", "09_joint_positions.py", "README.md", "notes.py"):
        (tmp_path / file).touch()
    assert stems(tmp_path) == ("05_timers", "09_joint_positions")
    assert find(tmp_path, name) == tmp_path / "05_timers.py"


def test_an_unknown_exercise_gets_a_suggestion(tmp_path: Path) -> None:
    with pytest.raises(UnknownExercise, match="has no exercises"):
        find(tmp_path, "timers")
    (tmp_path / "05_timers.py").touch()
    with pytest.raises(UnknownExercise, match="Did you mean timers"):
        find(tmp_path, "tmers")


code_line = st.sampled_from(
    ["x = 1", "    y = [solution]", "", "  # a remark", "# | not a starter", "#[]", "pass  # [end] no"]
)
starter_line = st.sampled_from(["z = 2", "    z = 3", "", "# TODO"])
common = st.lists(code_line, max_size=5)
part = st.tuples(common, common, st.lists(starter_line, max_size=4), st.sampled_from(["", "    "]))


@given(st.lists(part, max_size=5), common)
def test_lines_outside_of_marked_parts_go_to_both(
    parts: list[tuple[list[str], list[str], list[str], str]], tail: list[str]
) -> None:
    written: list[str] = []
    solution: list[str] = []
    starter: list[str] = []
    for before, solved, blank, indent in parts:
        written += [*before, f"{indent}# [solution]", *solved, f"{indent}# [starter]"]
        written += [f"{indent}# | {text}" if text else f"{indent}# |" for text in blank] + [
            f"{indent}# [end]"
        ]
        solution += before + solved
        starter += before + [indent + text if text else "" for text in blank]
    written += tail
    got_solution, got_starter = split_answer(list(enumerate(written, start=1)))
    assert [text for _, text in got_solution] == solution + tail
    assert [text for _, text in got_starter] == starter + tail
    assert all(written[number - 1] == text for number, text in got_solution)
