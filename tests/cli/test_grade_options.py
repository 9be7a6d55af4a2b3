"""Options and folders of `workbook grade` that can't have an effect are refused before any answer is judged."""

from pathlib import Path

import pytest

from workbook.cli.main import main

STEM = "09_joint_positions"


@pytest.fixture
def answers(tmp_path: Path) -> Path:
    folder = tmp_path / "answers"
    folder.mkdir()
    (folder / "s1.py").write_text("robot = 1\n")
    return folder


@pytest.mark.parametrize("name", [None, "joint_positions.py", "05_timers.py", f"{STEM}.txt"])
def test_criteria_that_belong_to_no_exercise_are_refused(
    name: str | None,
    answers: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("WORKBOOK_CRITERIA", "")
    own = tmp_path / "own"
    own.mkdir()
    if name is not None:
        (own / name).write_text("")
    out = tmp_path / "out"
    command = ["grade", str(answers), "--exercise", STEM, "--out", str(out), "--criteria", str(own)]
    assert main(command) == 2
    assert f"has no {STEM}.py" in capsys.readouterr().err
    assert not out.exists()


@pytest.mark.parametrize("name", [None, "notes.txt", "s1.py.txt", "venv/lib/site-packages/numpy.py"])
def test_a_folder_without_an_answer_is_refused(
    name: str | None, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    empty = tmp_path / "empty"
    empty.mkdir()
    if name is not None:
        (empty / name).parent.mkdir(parents=True, exist_ok=True)
        (empty / name).write_text("x = 1\n")
    command = [
        "grade",
        str(empty),
        "--exercise",
        STEM,
        "--out",
        str(tmp_path / "out"),
        "--isolation",
        "limits",
    ]
    assert main(command) == 2
    said = capsys.readouterr().err
    assert "there is no answer below" in said
    assert name != "s1.py.txt" or "s1.py.txt" in said
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("more", "words"),
    [
        (["--regrade"], "a path has no effect with --regrade"),
        (["--repeat", "2", "--override", "x.csv"], "--override has no effect with --repeat"),
        (["--column", "Exercise 09"], "--column needs --format canvas"),
    ],
)
def test_an_option_without_effect_is_refused(
    more: list[str], words: str, answers: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "x.csv").write_text("student,exercise,criterion,points,reason,who\n")
    options = [str(tmp_path / one) if one == "x.csv" else one for one in more]
    assert main(["grade", str(answers), "--exercise", STEM, "--out", str(tmp_path / "out"), *options]) == 2
    assert words in capsys.readouterr().err
