"""Find the answers among an instructor's files: single files, folders, nbgrader's layout, and accidents."""

import json
import os
from collections.abc import Callable
from pathlib import Path

import pytest

from workbook.grading.hand_ins import (
    HandIn,
    all_hand_ins,
    hand_in_below,
    infer_exercise,
    names_exercise,
    one_for_each,
)
from workbook.grading.roster import Roster, read_aliases

STEM = "09_joint_positions"
NOTEBOOK = json.dumps({"cells": [{"cell_type": "code", "source": f"%%answer {STEM}\nx = 1\n"}]})
OTHER_NOTEBOOK = json.dumps({"cells": [{"cell_type": "code", "source": "%%answer 05_timers\nx = 1\n"}]})

Tree = Callable[..., Path]


@pytest.fixture
def tree(tmp_path: Path) -> Tree:
    def make(*names: str, **contents: str) -> Path:
        for name in names:
            path = tmp_path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            text = NOTEBOOK if name.endswith(".ipynb") else "x = 1\n"
            path.write_text(contents.get(path.stem, text))
        return tmp_path

    return make


def found(*paths: Path) -> dict[str, HandIn]:
    hand_ins = one_for_each(all_hand_ins(paths, STEM))
    assert [one.student for one in hand_ins] == sorted(one.student for one in hand_ins)
    return {one.student: one for one in hand_ins}


def labels(*paths: Path) -> dict[str, str]:
    hand_ins = found(*paths)
    assert not any(one.problem for one in hand_ins.values()), hand_ins
    return {student: one.label for student, one in hand_ins.items()}


@pytest.mark.parametrize(
    ("names", "expected"),
    [
        (("s1042.py", "s1043.ipynb"), {"s1042": "s1042.py", "s1043": "s1043.ipynb"}),
        (("s1042/answer.py",), {"s1042": "s1042/answer.py"}),
        (("s1042/deep/down/anything.py",), {"s1042": "s1042/deep/down/anything.py"}),
        (("submitted/s1042/09/09_joint_positions.ipynb",), {"s1042": "s1042/09/09_joint_positions.ipynb"}),
        (("s1042/helper.py", "s1042/09_joint_positions.py"), {"s1042": "s1042/09_joint_positions.py"}),
        (("s1042/a.py", "s1042/Joint-Positions final.py"), {"s1042": "s1042/Joint-Positions final.py"}),
        (("s1042/a.py", "s1042/homework.ipynb"), {"s1042": "s1042/homework.ipynb"}),
        (
            (
                "s1042/a.py",
                "s1042/__pycache__/a.py",
                "s1042/.ipynb_checkpoints/a-checkpoint.ipynb",
                "__MACOSX/b.py",
            ),
            {"s1042": "s1042/a.py"},
        ),
        (
            ("s1042.py", ".hidden.py", "__init__.py", "notes.txt", "grades.csv", ".git/x.py"),
            {"s1042": "s1042.py"},
        ),
        (("s1042/a.py", "s1042/.secret.py", "s1042/__init__.py"), {"s1042": "s1042/a.py"}),
        ((), {}),
    ],
)
def test_every_layout_is_understood(names: tuple[str, ...], expected: dict[str, str], tree: Tree) -> None:
    assert labels(tree(*names)) == expected


# --- nbgrader -----------------------------------------------------------------------------------------------------


def in_nbgrader(tree: Tree, assignment: str | None, *names: str) -> dict[str, tuple[str, str | None]]:
    hand_ins = one_for_each(
        all_hand_ins([tree(*(f"course/submitted/{name}" for name in names)) / "course"], STEM, assignment)
    )
    return {one.student: (one.label, one.problem) for one in hand_ins}


def test_in_nbgrader_the_folder_of_the_assignment_is_looked_at_and_no_other(tree: Tree) -> None:
    found = in_nbgrader(
        tree,
        "ps2",
        "ada/ps1/problem.ipynb",
        "ada/ps2/problem.ipynb",
        "bob/ps2/deep/node.py",
        "bob/ps2x/node.py",
    )
    assert found == {"ada": ("ada/ps2/problem.ipynb", None), "bob": ("bob/ps2/deep/node.py", None)}


def test_an_assignment_that_is_named_after_the_exercise_need_not_be_told(tree: Tree) -> None:
    found = in_nbgrader(
        tree, None, "ada/05_timers/a.py", "ada/Joint Positions/a.py", "ada/Joint Positions/b.txt"
    )
    assert found == {"ada": ("ada/Joint Positions/a.py", None)}


def test_who_handed_in_other_assignments_only_is_told_so(tree: Tree) -> None:
    label, problem = in_nbgrader(tree, "ps2", "ada/ps1/problem.ipynb")["ada"]
    assert (label, problem) == ("ada", "there is no folder ps2: nothing was handed in for it")


def test_an_assignment_that_is_a_link_is_not_followed(tree: Tree) -> None:
    root = tree("submitted/ada/ps1/a.py")
    (root / "submitted" / "ada" / "ps2").symlink_to(root / "submitted" / "ada" / "ps1")
    [hand_in] = one_for_each(all_hand_ins([root], STEM, "ps2"))
    assert "no folder ps2" in (hand_in.problem or "")


def test_the_folder_submitted_itself_may_be_named(tree: Tree) -> None:
    root = tree("course/submitted/ada/ps2/a.py")
    [hand_in] = one_for_each(all_hand_ins([root / "course" / "submitted"], STEM, "ps2"))
    assert (hand_in.student, hand_in.label) == ("ada", "ada/ps2/a.py")


# --- one folder per student ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("names", "label", "problem"),
    [
        (("a.py",), "a.py", None),
        (("deep/down/a.ipynb",), "deep/down/a.ipynb", None),
        (("notes.txt",), ".", "the folder holds no .py and no .ipynb file"),
        (("a.py", "b.py"), ".", f"2 files could be the answer to {STEM}: a.py, b.py. Leave one"),
        (("a.py", "joint_positions.py"), "joint_positions.py", None),
    ],
)
def test_what_one_student_handed_in(
    names: tuple[str, ...], label: str, problem: str | None, tree: Tree
) -> None:
    hand_in = hand_in_below("ada", tree(*names), STEM)
    assert (hand_in.student, hand_in.label, hand_in.problem) == ("ada", label, problem)


def test_a_folder_that_is_not_there_is_nothing_handed_in(tree: Tree) -> None:
    assert hand_in_below("ada", tree() / "nowhere", STEM).problem == "nothing was handed in"


# --- accidents ----------------------------------------------------------------------------------------------------


def test_files_named_one_by_one(tree: Tree) -> None:
    root = tree("s1042.py", "s1043.ipynb", "s1044.py")
    assert labels(root / "s1042.py", root / "s1043.ipynb") == {"s1042": "s1042.py", "s1043": "s1043.ipynb"}


def test_a_path_that_is_not_there_is_said(tree: Tree) -> None:
    with pytest.raises(FileNotFoundError, match="nowhere"):
        found(tree() / "nowhere")


def test_two_candidates_of_one_student_are_not_guessed_between(tree: Tree) -> None:
    root = tree(
        "s1042/first.py", "s1042/second.py", "s1043/09_joint_positions.py", "s1043/joint_positions_2.py"
    )
    hand_ins = found(root)
    assert (
        hand_ins["s1042"].problem == f"2 files could be the answer to {STEM}: first.py, second.py. Leave one"
    )
    assert "09_joint_positions.py, joint_positions_2.py" in (hand_ins["s1043"].problem or "")


def test_a_folder_without_answer_says_so(tree: Tree) -> None:
    root = tree("s1042/report.pdf")
    assert "no .py and no .ipynb" in (found(root)["s1042"].problem or "")


def test_a_student_with_a_file_and_a_folder_is_refused_once(tree: Tree) -> None:
    hand_ins = found(tree("s1042.py", "s1042/answer.py", "s1043.py"))
    assert "2 hand-ins of one student" in (hand_ins["s1042"].problem or "")
    assert "s1042.py" in (hand_ins["s1042"].problem or "")
    assert hand_ins["s1043"].problem is None


def test_the_same_file_named_twice_is_two_hand_ins(tree: Tree) -> None:
    root = tree("s1042.py")
    assert "2 hand-ins" in (found(root / "s1042.py", root / "s1042.py")["s1042"].problem or "")


def test_links_are_refused_and_not_followed(tree: Tree, tmp_path_factory: pytest.TempPathFactory) -> None:
    outside = tmp_path_factory.mktemp("outside")
    (outside / "secret.py").write_text("x = 1\n")
    root = tree("s1042.py")
    (root / "s1043.py").symlink_to(outside / "secret.py")
    (root / "s1044").symlink_to(outside)
    (root / "s1045").mkdir()
    (root / "s1045" / "deeper").symlink_to(outside)
    hand_ins = found(root)
    assert "symbolic link" in (hand_ins["s1043"].problem or "")
    assert "symbolic link" in (hand_ins["s1044"].problem or "")
    assert "no .py and no .ipynb" in (hand_ins["s1045"].problem or "")


def test_a_pipe_does_not_hang_the_search(tree: Tree) -> None:
    root = tree("s1042/answer.py")
    os.mkfifo(root / "s1042" / "pipe.py")
    os.mkfifo(root / "s1042" / "pipe.ipynb")
    assert "3 files" in (found(root)["s1042"].problem or "")
    assert infer_exercise([root], [STEM]) == []


def test_names_that_are_no_unicode_become_text(tree: Tree) -> None:
    root = tree()
    (root / os.fsdecode(b"m\xfcller.py")).write_text("x = 1\n")
    hand_ins = found(root)
    assert list(hand_ins) == ["m\\xfcller"]
    assert hand_ins["m\\xfcller"].path.read_text() == "x = 1\n"
    json.dumps([one.label for one in hand_ins.values()], ensure_ascii=False).encode()


def test_the_exercise_is_inferred_from_names_and_cells(tree: Tree) -> None:
    stems = ["05_timers", STEM]
    assert infer_exercise([tree("s1042/joint_positions.py")], stems) == [STEM]
    assert infer_exercise([tree("s1043.ipynb")], stems) == [STEM]
    both = tree("s1044.ipynb", s1044=OTHER_NOTEBOOK)
    assert infer_exercise([both], stems) == stems
    assert infer_exercise([both / "s1044.ipynb"], stems) == ["05_timers"]


def test_a_file_that_says_nothing_names_no_exercise(tree: Tree) -> None:
    root = tree("s1042.py", "s1043_timers.py")
    assert infer_exercise([root / "s1042.py"], [STEM]) == []
    assert names_exercise(root / "s1043_timers.py", "05_timers")
    assert not names_exercise(root / "s1043_timers.py", STEM)


def test_names_that_look_alike_are_one_student(tree: Tree, tmp_path_factory: pytest.TempPathFactory) -> None:
    together, apart = "Zo\u00eb", "Zoe\u0308"
    assert list(found(tree(f"{apart}.py"))) == [together]
    aliases = tmp_path_factory.mktemp("aliases") / "who.csv"
    aliases.write_text(f"{together}.py,s1\n", encoding="utf-8")
    whole = all_hand_ins([tree()], STEM)
    assert [one.student for one in Roster(read_aliases(aliases)).hand_ins(whole)] == ["s1"]
    both = found(tree(f"{together}.py"))
    assert list(both) == [together]
    assert "2 hand-ins of one student" in (both[together].problem or "")
