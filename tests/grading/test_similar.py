"""`--similar` finds answers that differ only in names and layout, and no others."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from workbook.cli.main import main
from workbook.exercise.definition import load_exercise
from workbook.grading.similar import compare

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
SOURCE = load_exercise(STEM, ROOT).source
SOLUTION, STARTER = SOURCE.solution_code, SOURCE.starter_code
OWN_WORDS = {"self.publisher": "self._outlet", "msg": "reading", "node": "robot", "message": "packet"}


def renamed(text: str) -> str:
    """Return the same program with other names, comments, quotes of the same kind, and blank lines."""
    for old, new in OWN_WORDS.items():
        text = re.sub(rf"(?<![\w\"'.]){re.escape(old)}\b(?![\"'(])", new, text)
    lines = (f"{line}  # as we know" if line.endswith(")") else line for line in text.splitlines())
    return "\n\n".join(lines) + "\n"


def other(number: int) -> str:
    """Return a program that shares nothing with the solution, except Python."""
    return "\n".join(
        f"while total_{n} {'<>'[n % 2]} {'+-*/'[(n + number) % 4].join('ab'[: n % 3])}9 ** {n * number}: print({n})"
        for n in range(1, 40)
    )


def test_an_answer_with_other_names_and_layout_is_found() -> None:
    text = renamed(SOLUTION)
    assert text != SOLUTION
    found = compare({"ada": SOLUTION, "bob": text, "cyd": other(1)}, STARTER)
    assert [(one.one, one.other, one.share) for one in found.pairs] == [("ada", "bob", 1.0)]
    assert found.compared == 3


def test_what_the_starter_gave_is_no_similarity() -> None:
    one, two = (f"{STARTER}\n{other(number)}\n" for number in (1, 2))
    assert compare({"ada": one, "bob": two}, STARTER).pairs == ()
    assert compare({"ada": one, "bob": one}, STARTER).pairs[0].share == 1.0
    found = compare({"ada": STARTER, "bob": STARTER, "cyd": ""}, STARTER)
    assert (found.pairs, found.compared, set(found.too_short)) == ((), 0, {"ada", "bob", "cyd"})


def test_an_endless_answer_is_left_out() -> None:
    found = compare({"ada": "x = 1\n" * 100_000, "bob": SOLUTION}, STARTER)
    assert (found.too_long, found.compared) == (("ada",), 1)


def hand_in(folder: Path, **answers: str) -> Path:
    folder.mkdir()
    for name, text in answers.items():
        (folder / f"{name}.py").write_text(text)
    return folder


def test_the_command_lists_pairs_says_it_is_a_hint_and_judges_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    answers = hand_in(
        tmp_path / "a", ada=SOLUTION, bob=renamed(SOLUTION), cyd=other(1), dan="", eve="x = 1\n"
    )
    out = tmp_path / "out"
    assert main(["grade", str(answers), "--exercise", STEM, "--out", str(out), "--similar"]) == 0
    said = capsys.readouterr().out
    assert f"3 answers to {STEM} compared: 1 pair is nearly the same." in said
    assert "  100%  ada  bob\n" in said
    assert "too short to compare: eve." in said and "could not be read: dan." in said
    assert "This is a hint, not a verdict." in said
    assert not out.exists()


@pytest.mark.parametrize("more", [["--repeat", "2"], ["--regrade"], ["--override", "x.csv"]])
def test_no_other_option_is_without_effect(
    tmp_path: Path, more: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    answers = hand_in(tmp_path / "a", ada=SOLUTION)
    (tmp_path / "x.csv").write_text(f"ada,{STEM},total,1,because,me\n")
    more = [str(tmp_path / one) if one == "x.csv" else one for one in more]
    assert main(["grade", str(answers), "--exercise", STEM, "--out", str(tmp_path), "--similar", *more]) == 2
    assert re.search("can't be combined with|has no effect with", capsys.readouterr().err)


def test_without_the_extra_one_sentence_says_what_to_install(tmp_path: Path) -> None:
    answers = hand_in(tmp_path / "a", ada=SOLUTION)
    code = (
        "import sys; sys.modules['copydetect'] = None; from workbook.cli.main import main; "
        "sys.exit(main(sys.argv[1:]))"
    )
    command = ["grade", str(answers), "--exercise", STEM, "--out", str(tmp_path), "--similar"]
    done = subprocess.run(
        [sys.executable, "-c", code, *command], capture_output=True, text=True, check=False, cwd=ROOT
    )
    assert done.returncode == 2
    assert "make env EXTRAS=similar" in done.stderr and "Traceback" not in done.stderr
