"""Wrong answers: a change applies exactly once or is refused with file and line, and the header is parsed."""

from pathlib import Path

import pytest

from workbook.authoring.tree import Tree
from workbook.authoring.wrong_answers import (
    WrongAnswerError,
    read_header,
    read_wrong_answer,
)

ROOT = Path(__file__).resolve().parents[2]
STEM = "20_horn"
SOLUTION = """
# ---
# exercise: 20_horn
# title: The horn
# minutes: 5
# difficulty: 1
# kind: program
# clock: simulated
# objectives: [one]
# out_of_scope: [two]
# ---
# %% [markdown]
# # The horn
# %% [answer]
class Horn:
    def __init__(self):
        self.honks = 0

    def honk(self):
        # [solution]
        self.honks += 1
        if self.honks > 3:
            print("tired")
            return
        print("honk")
        # [starter]
        # | pass
        # [end]

    def rest(self):
        self.honks = 0
        print("quiet")
# %% [hint]
# One.
# %% [hint]
# Two.
# %% [hint]
# Three.
# %% [alternatives]
# None.
""".lstrip()
RIGHT = """
class Horn:
    def honk(self):
        print("honk")
""".lstrip()
HONK = """
        self.honks += 1
        if self.honks > 3:
            print("tired")
            return
        print("honk")
""".strip("\n")


@pytest.fixture
def tree(tmp_path: Path) -> Tree:
    tree = Tree(tmp_path)
    for folder in (tree.solutions, tree.right_answers / STEM, tree.wrong_answers / STEM):
        folder.mkdir(parents=True)
    (tree.solutions / f"{STEM}.py").write_text(SOLUTION, encoding="utf-8")
    (tree.right_answers / STEM / "short.py").write_text(RIGHT, encoding="utf-8")
    return tree


def wrong(tree: Tree, text: str, header: str = "# loses: loud\n# says: honk\n") -> Path:
    path = tree.wrong_answers / STEM / "wrong.py"
    path.write_text(header + text, encoding="utf-8")
    return path


def program(tree: Tree, text: str, header: str = "# loses: loud\n# says: honk\n") -> str:
    return read_wrong_answer(tree, wrong(tree, text, header)).answer.text


def honk(body: str) -> str:
    """Return the solution with other lines in `honk`."""
    return (
        f"class Horn:\n    def __init__(self):\n        self.honks = 0\n\n    def honk(self):\n{body}\n\n"
        '    def rest(self):\n        self.honks = 0\n        print("quiet")\n'
    )


def test_a_line_gives_way_and_its_depth_stays(tree: Tree) -> None:
    changed = program(tree, '# replaces: print("honk")\nprint("hoot")\n')
    assert changed == honk(HONK.replace('"honk"', '"hoot"'))


def test_several_lines_give_way_with_their_depths_in_relation(tree: Tree) -> None:
    text = '# replaces: if self.honks > 3:\n# replaces:     print("tired")\n\nif self.honks > 5:\n    print("sad")\n'
    assert program(tree, text) == honk(HONK.replace("> 3", "> 5").replace("tired", "sad"))


def test_lines_may_carry_their_depth(tree: Tree) -> None:
    text = '# replaces:     self.honks = 0\n# replaces:     print("quiet")\n    print("quiet")\n'
    assert program(tree, text) == honk(HONK).replace(
        '        self.honks = 0\n        print("q', '        print("q'
    )


def test_code_may_stand_further_left_than_the_lines_that_it_follows(tree: Tree) -> None:
    text = '# after:         print("honk")\n    def cough(self):\n        pass\nhorn = Horn()\n'
    added = "\n    def cough(self):\n        pass\nhorn = Horn()"
    assert (
        program(tree, text, "# loses: loud\n# says: honk\n# on: right/short.py\n")
        == RIGHT.strip() + added + "\n"
    )


def test_nothing_below_takes_the_lines_away(tree: Tree) -> None:
    assert program(tree, "# replaces: self.honks += 1\n") == honk(
        HONK.replace("        self.honks += 1\n", "")
    )


def test_a_line_stays_and_code_is_put_below_it(tree: Tree) -> None:
    changed = program(tree, '# after: print("honk")\nif True:\n    print("again")\n')
    assert changed == honk(f'{HONK}\n        if True:\n            print("again")')


def test_a_line_stays_and_code_is_put_above_it(tree: Tree) -> None:
    changed = program(tree, "# before: def rest(self):\ndef cough(self):\n    pass\n")
    assert changed == honk(HONK).replace("    def rest", "    def cough(self):\n        pass\n    def rest")


def test_changes_apply_to_the_right_program_in_any_order(tree: Tree) -> None:
    text = '# replaces: print("quiet")\nprint("honk")\n\n# replaces: print("honk")\nprint("quiet")\n'
    changed = honk(HONK.replace('"honk"', '"quiet"'))
    assert program(tree, text) == changed.removesuffix('print("quiet")\n') + 'print("honk")\n'


def test_a_comment_in_the_code_is_code(tree: Tree) -> None:
    changed = program(tree, '# replaces: print("honk")\n# loud\nprint("honk")  # louder\n')
    assert changed == honk(
        HONK.replace('        print("honk")', '        # loud\n        print("honk")  # louder')
    )


def test_a_right_answer_can_be_changed(tree: Tree) -> None:
    header = "# loses: loud\n# says: honk\n# on: right/short.py\n"
    assert program(tree, '# replaces: print("honk")\nprint("")\n', header) == RIGHT.replace('"honk"', '""')


def test_the_starter_can_be_changed(tree: Tree) -> None:
    header = "# loses: loud\n# says: honk\n# on: starter\n"
    assert program(tree, "# replaces: pass\nself.honks += 1\n", header) == honk("        self.honks += 1")


def test_a_file_without_changes_is_a_whole_program(tree: Tree) -> None:
    path = wrong(tree, '"""Silence."""\n# replaces: this is a comment of the program\n')
    answer = read_wrong_answer(tree, path)
    assert answer.changes == ()
    assert answer.answer.text == path.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (
            '# replaces: print("hoot")\nprint()\n',
            r"wrong\.py:3: must be found once .* not 0 times:\nprint\(\"hoot\"\)",
        ),
        ("\n# replaces: self.honks = 0\nx = 1\n", r"wrong\.py:4: must be found once .* not 2 times"),
        (
            '# replaces: print("honk")\nprint()\n# after: if self.honks > 3:\n# after: print("tired")\nx = 1\n',
            r"wrong\.py:5: .* not 0 times",
        ),
        (
            '# replaces: print("honk")\nx = 1\n# after: print("honk")\nx = 2\n',
            r":5: .* another change has changed",
        ),
        ('# replaces: print("honk")\nprint("honk")\n', "is the program that it changes"),
        ('# replaces: print("honk")\nprint("honk"\n', "does not compile: .*'# compiles: no'"),
        ('# replaces: print("honk")\n# after: print("honk")\nx\n', ":3: mixes"),
        ("# replaces:\nx = 1\n", ":3: names no line"),
        ("# after: self.honks += 1\n", ":3: puts nothing after"),
        ('# after:             print("honk")\nx = 1\n', ":3: its lines are indented more here"),
        ("# before: self.honks += 1\n", ":3: puts nothing before"),
    ],
)
def test_a_change_that_does_not_apply_is_refused(tree: Tree, text: str, says: str) -> None:
    with pytest.raises(WrongAnswerError, match=says):
        read_wrong_answer(tree, wrong(tree, text))


@pytest.mark.parametrize(
    ("header", "says"),
    [
        ("# says: honk\n", r"wrong\.py:1: must begin with '# loses: '"),
        ("# loses: loud\n", "needs '# cause: '"),
        ("# lose: loud\n# says: honk\n", ":1: unknown field 'lose'. Did you mean loses"),
        ("# loses:\n# says: honk\n", ":1: '# loses:' is empty"),
        ("# loses: loud\n# cause: a\n# cause: b\n", ":3: .* second time"),
        ("# loses: loud\n# says: honk\n# soak: no\n", "'# soak:' must be 'yes', not 'no'"),
        ("# loses: loud\n# says: honk\n# compiles: no\n", "says '# compiles: no', but it does compile"),
        ("# loses: loud\n# says: honk\n# on: right/long.py\n", "write solution, starter or right/NAME.py"),
        ("# loses: loud\n# says: honk\n# on: short.py\n", "write solution, starter or right/NAME.py"),
    ],
)
def test_a_header_that_is_not_understood_is_refused(tree: Tree, header: str, says: str) -> None:
    with pytest.raises(WrongAnswerError, match=says):
        read_wrong_answer(tree, wrong(tree, '# replaces: print("honk")\nprint()\n', header))


def test_a_program_is_named_only_to_be_changed(tree: Tree) -> None:
    with pytest.raises(WrongAnswerError, match="changes nothing in it"):
        read_wrong_answer(tree, wrong(tree, "x = 1\n", "# loses: loud\n# says: honk\n# on: solution\n"))


def test_a_header_says_everything_that_is_expected(tree: Tree) -> None:
    header = read_header(
        wrong(
            tree,
            '# replaces: print("honk")\nprint(\n',
            "# A bracket\n# is open.\n# loses: loud, long\n# skips: last\n# cause: syntax.error\n"
            "# says: was never: closed\n# says: line 3\n# soak: yes\n# compiles: no\n",
        )
    )
    assert header.about == "A bracket is open."
    assert header.loses == {"loud", "long"}
    assert header.skips == frozenset({"last"})
    assert header.causes == {"syntax.error"}
    assert header.says == ("was never: closed", "line 3")
    assert header.soak
    assert not header.compiles
    assert header.on is None


def test_what_does_not_compile_is_read_where_it_should_not(tree: Tree) -> None:
    header = "# loses: loud\n# says: honk\n# compiles: no\n"
    assert "print(\n" in program(tree, '# replaces: print("honk")\nprint(\n', header)


@pytest.mark.parametrize("stem", Tree(ROOT).exercise_stems())
def test_every_wrong_answer_of_an_exercise_is_another_program(stem: str) -> None:
    programs: dict[str, str] = {}
    tree = Tree(ROOT)
    for path in sorted((tree.wrong_answers / stem).glob("*.py")):
        one = read_wrong_answer(tree, path)
        first = programs.setdefault(one.answer.text, one.path.name)
        assert first == one.path.name, f"{one.path.name} is the same program as {first}"
    assert programs
