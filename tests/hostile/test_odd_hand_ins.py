"""Odd or malicious hand-ins: their names, folders, and notebooks. None of them stops the others."""

import base64
import csv
import hashlib
import json
import os
import re
import resource
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import pytest

from workbook.exercise import answers, notebook_cells
from workbook.exercise.answers import Ungradable, exercises_named, read_answer
from workbook.grading.hand_ins import all_hand_ins, hand_in_named, one_for_each
from workbook.grading.skipped import find_skipped
from workbook.isolation.bubblewrap import sandbox_problem
from workbook.recording.plain_text import without_commands
from workbook.ros.scratch import remove_scratch

pytestmark = [pytest.mark.slow, pytest.mark.whole]

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
CANNOT_RUN = "robot = = 1\n"
FORMATS = "html,gradescope,canvas,moodle,nbgrader"
NAMES = [
    b"two\nlines",
    b"comma, quote\" and 'quote",
    b"$(reboot)",
    b"`reboot`; reboot | reboot & reboot",
    b"-rf",
    b"--help",
    b"=HYPERLINK(1)",
    b"@SUM(A1)",
    b"<script>alert(1)<%2Fscript>",
    b"\x1b[2Jescape",
    "\u202eturned".encode(),
    b"m\xfcller",
    b"m\xe4ller",
    b"Ada",
    b"ada",
    b"CON",
    b" blank ",
    b"%s%n{0}",
    b"x" * 252,
]


def workbook(*arguments: object) -> "subprocess.CompletedProcess[str]":
    command = [sys.executable, "-m", "workbook.cli.main", *map(str, arguments)]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, stdin=subprocess.DEVNULL)


def notebook(*cells: object, **more: Any) -> str:
    made = [
        {"cell_type": "code", "id": "same", "metadata": {}, "outputs": [], "source": cell} for cell in cells
    ]
    return json.dumps({"cells": made, "metadata": {}, "nbformat": 4, "nbformat_minor": 5, **more})


# --- names ----------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def graded(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, "subprocess.CompletedProcess[str]"]:
    folder = tmp_path_factory.mktemp("odd")
    (folder / "class").mkdir()
    for name in NAMES:
        (folder / "class" / os.fsdecode(name + b".py")).write_text(CANNOT_RUN)
    isolation = (
        "limits" if sandbox_problem() else "sandbox"
    )  # these answers do nothing, because only their names matter
    done = workbook(
        *("grade", folder / "class", "--exercise", STEM, "--out", folder / "out", "--slots", 3),
        *("--format", FORMATS, "--isolation", isolation),
    )
    return folder / "out", done


def test_everybody_is_graded_whatever_the_name(
    graded: tuple[Path, "subprocess.CompletedProcess[str]"],
) -> None:
    out, done = graded
    assert done.returncode == 0, done.stderr
    results = [json.loads(line) for line in (out / "results.jsonl").read_bytes().split(b"\n")[:-1]]
    assert {one["status"] for one in results} == {"graded"}
    students = {one["student"] for one in results}
    assert len(students) == len(results) == len(NAMES)
    assert students == {name.decode("utf-8", "backslashreplace") for name in NAMES}


def test_every_table_has_one_row_for_each_and_no_formula(
    graded: tuple[Path, "subprocess.CompletedProcess[str]"],
) -> None:
    out, _ = graded
    for table, head in (("grades.csv", 1), ("canvas.csv", 2), ("moodle.csv", 1), ("nbgrader.csv", 1)):
        with (out / table).open(newline="", encoding="utf-8-sig") as file:
            rows = list(csv.reader(file))
        assert len(rows) == len(NAMES) + head
        assert len({len(row) for row in rows}) == 1
        assert not [cell for row in rows for cell in row if cell.startswith(("=", "+", "-", "@"))]


def test_every_page_is_written_and_none_runs_anything(
    graded: tuple[Path, "subprocess.CompletedProcess[str]"],
) -> None:
    out, _ = graded
    pages = list((out / "pages").iterdir())
    assert len(pages) == len(NAMES) + 1
    for page in pages:
        text = page.read_text(encoding="utf-8")
        scripts = re.findall(r"<script>(.*?)</script>", text, re.DOTALL)
        assert len(scripts) == text.lower().count("<script") == (page.name == "class.html"), page.name
        for script in scripts:
            allowed = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
            assert f"script-src 'sha256-{allowed}'" in text, "no other script may run"
    assert len(list((out / "gradescope").iterdir())) == len(NAMES)


def test_nothing_that_is_printed_commands_the_terminal(
    graded: tuple[Path, "subprocess.CompletedProcess[str]"],
) -> None:
    _, done = graded
    for said in (done.stdout, done.stderr):
        assert without_commands(said) == said
        assert "Traceback" not in said


# --- folders ----------------------------------------------------------------------------------------------------------


def problem_of(folder: Path, student: str = "s1") -> str:
    [found] = [one for one in one_for_each(all_hand_ins([folder], STEM)) if one.student == student]
    return found.problem or ""


def test_an_archive_is_not_opened(tmp_path: Path) -> None:
    bomb = tmp_path / "s1.zip"
    with zipfile.ZipFile(bomb, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("../../../etc/cron.d/x", "reboot")
        archive.writestr("/etc/passwd", "root")
        archive.writestr("s1.py", b"#" * 10_000_000)
    before = sorted(tmp_path.rglob("*"))
    assert "archives are not opened: unpack it" in problem_of(tmp_path)
    assert sorted(tmp_path.rglob("*")) == before
    (tmp_path / "s2").mkdir()
    bomb.rename(tmp_path / "s2" / "answer.tar.gz")
    assert "but answer.tar.gz; archives are not opened" in problem_of(tmp_path, "s2")


def test_files_with_names_of_modules_are_no_answers(tmp_path: Path) -> None:
    student = tmp_path / "s1"
    (student / "std_msgs").mkdir(parents=True)
    for name in ("rclpy.py", "sitecustomize.py", "usercustomize.py", "conftest.py", "std_msgs/__init__.py"):
        (student / name).write_text("raise SystemExit\n")
    (student / "evil.pth").write_text("import os; os._exit(0)\n")
    assert "a name that no ROS or Python module has" in problem_of(tmp_path)
    (student / "mine.py").write_text("print()\n")
    [found] = one_for_each(all_hand_ins([tmp_path], STEM))
    assert (found.problem, found.path.name) == (None, "mine.py")


@pytest.mark.parametrize("target", ["/etc/passwd", "../s2/answer.py", "/dev/zero", "/proc/self/environ"])
def test_a_link_is_no_answer(tmp_path: Path, target: str) -> None:
    for student in ("s1", "s2"):
        (tmp_path / student).mkdir()
    (tmp_path / "s2" / "answer.py").write_text("print('the work of s2')\n")
    (tmp_path / "s1" / "answer.py").symlink_to(target)
    found = {one.student: one for one in one_for_each(all_hand_ins([tmp_path], STEM))}
    assert read_answer(found["s2"].path, STEM).text == "print('the work of s2')\n"
    with pytest.raises(Ungradable, match="not a regular file"):
        read_answer(found["s1"].path, STEM)


def test_a_folder_of_answers_that_is_a_link_leads_to_no_solutions(tmp_path: Path) -> None:
    """In a class repository, the answers are next to the course.

    A student pushes `answers` as a link, or a link in a folder of that name.
    """
    (tmp_path / "answers").symlink_to(ROOT / "solutions")
    found = hand_in_named("the pushed answer", tmp_path, STEM)
    assert found is not None
    assert found.problem == "`answers` is a symbolic link: links are not followed"
    (tmp_path / "answers").unlink()
    (tmp_path / "answers").mkdir()
    (tmp_path / "answers" / "more").symlink_to(ROOT / "solutions")
    assert hand_in_named("the pushed answer", tmp_path, STEM) is None


def test_folders_without_end_stop_nobody(tmp_path: Path) -> None:
    """Folders nested deeper than Python's recursion limit, and circular links; s2 is found anyway."""
    deep = tmp_path / "s1"
    try:
        for _ in range(1100):
            os.mkdir(deep)
            deep /= "d"
        (tmp_path / "s2" / "a").mkdir(parents=True)
        (tmp_path / "s2" / "a" / "answer.py").write_text(CANNOT_RUN)
        (tmp_path / "s2" / "a" / "back").symlink_to("..")
        (tmp_path / "s2" / "a" / "itself.py").symlink_to("itself.py")
        os.mkfifo(tmp_path / "s3.py")
        found = {one.student: one for one in one_for_each(all_hand_ins([tmp_path], STEM))}
        assert find_skipped([tmp_path]) == []
        assert "holds no .py" in (found["s1"].problem or "")
        assert found["s2"].problem is not None and "itself.py" in found["s2"].problem
        (tmp_path / "s2" / "a" / "itself.py").unlink()
        [second] = [one for one in one_for_each(all_hand_ins([tmp_path], STEM)) if one.student == "s2"]
        assert read_answer(second.path, STEM).text == CANNOT_RUN
        with pytest.raises(Ungradable, match="not a regular file"):
            read_answer(found["s3"].path, STEM)
    finally:
        remove_scratch(tmp_path / "s1")


# --- notebooks --------------------------------------------------------------------------------------------------------


def text_in(folder: Path, content: str) -> str:
    path = folder / "s1.ipynb"
    path.write_text(content, encoding="utf-8")
    return read_answer(path, STEM).text


ANSWER = f"%%answer {STEM}\nprint('the answer')\n"


@pytest.mark.parametrize(
    "content",
    [
        notebook("!rm -rf /", "%%bash\nreboot", "%load_ext evil", ANSWER, "raise SystemExit"),
        notebook(ANSWER, metadata={"kernelspec": {"name": "ir", "language": "R"}}),
        notebook(f"%%answer {STEM}\nprint('an old one')\n", ANSWER),
        notebook(ANSWER, metadata={"widgets": "<script>alert(1)</script>", "language_info": None}),
    ],
    ids=["other cells", "another kernel", "duplicated ids", "odd metadata"],
)
def test_only_the_answer_cell_counts(tmp_path: Path, content: str) -> None:
    assert text_in(tmp_path, content) == "print('the answer')\n"


def test_large_outputs_are_ignored_and_too_large_ones_said(tmp_path: Path) -> None:
    made = json.loads(notebook(ANSWER))
    size = answers.LARGEST_NOTEBOOK_BYTES - 10_000
    made["cells"][0]["outputs"] = [{"output_type": "stream", "name": "stdout", "text": "x" * size}]
    assert text_in(tmp_path, json.dumps(made)) == "print('the answer')\n"
    made["cells"][0]["outputs"][0]["text"] += "x" * 10_000
    with pytest.raises(Ungradable, match=r"larger than 50 MB\. Clear the outputs"):
        text_in(tmp_path, json.dumps(made))


def test_a_notebook_of_nothing_but_brackets_is_refused(tmp_path: Path) -> None:
    content = '{"cells": [' + "{}," * (notebook_cells.MOST_PARTS + 1) + "{}]}"
    with pytest.raises(Ungradable, match="not a notebook"):
        text_in(tmp_path, content)


def test_a_large_notebook_is_read_within_bounds_that_the_refusal_names(tmp_path: Path) -> None:
    """Millions of different keys, and text that needs four times its size in memory. Only the reader process grows."""
    path = tmp_path / "s1.ipynb"
    with path.open("w") as file:
        file.write('{"cells": [], "metadata": {')
        for start in range(0, 4_500_000, 10_000):
            file.write("".join(f'"{number:x}":1,' for number in range(start, start + 10_000)))
        file.write('"end": 1}}')
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with pytest.raises(Ungradable, match=r"takes more than (500 MB of memory|5 s of processor time)\. Clear"):
        read_answer(path, STEM)
    grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    assert grown < 50_000, f"{grown} kB"


def test_a_large_notebook_of_an_honest_student_is_read(tmp_path: Path) -> None:
    made = json.loads(notebook(ANSWER, "print('🤖')"))
    made["cells"][1]["outputs"] = [{"output_type": "display_data", "data": {"image/png": "x" * 30_000_000}}]
    path = tmp_path / "s1.ipynb"
    path.write_text(json.dumps(made, ensure_ascii=False), encoding="utf-8")
    assert read_answer(path, STEM).text == "print('the answer')\n"
    assert exercises_named(path) == [STEM]


@pytest.mark.parametrize("line_end", ["\r", "\r\n", "\n\r"])
def test_no_line_end_hides_a_coding_line_from_those_who_read_the_program(
    tmp_path: Path, line_end: str
) -> None:
    """In UTF-7, `+AAo-` ends a line, so Python would run what all other readers consider a comment."""
    cell = f"%%answer {STEM}\n{line_end}# coding: utf-7\nx = 1  # +AAo-print('hidden')\n"
    program = tmp_path / "program.py"
    program.write_bytes(text_in(tmp_path, notebook(cell)).encode())
    assert b"\r" not in program.read_bytes()
    done = subprocess.run([sys.executable, program], capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (0, "")


def test_a_reader_that_takes_too_long_is_stopped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(notebook_cells, "PATIENCE_S", 0.001)
    path = tmp_path / "s1.ipynb"
    path.write_text(notebook(ANSWER, "#" * 2_000_000))
    with pytest.raises(Ungradable, match="takes more than 5 s of processor time"):
        read_answer(path, STEM)


@pytest.mark.parametrize("suffix", [".py", ".ipynb"])
def test_a_zero_byte_is_refused_wherever_it_stands(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"s1{suffix}"
    program = "x = 1\n# \0\n"
    path.write_text(program if suffix == ".py" else notebook(f"%%answer {STEM}\n{program}"))
    with pytest.raises(Ungradable, match="null bytes"):
        read_answer(path, STEM)


DEEP = {
    "minus": "x = " + "-" * 100_000 + "1",
    "attributes": "x = a" + ".b" * 100_000,
    "calls": "x = a" + "()" * 100_000,
    "sum": "x = 1" + "+1" * 100_000,
    "lambdas": "x = " + "lambda:" * 30_000 + "1",
    "elif": "if a:\n pass\n" + "elif a:\n pass\n" * 30_000,
    "parentheses": "(" * 100_000,
    "comments": "# mypy: x\n" * 99_000,
}


@pytest.mark.parametrize("name", DEEP)
def test_deeply_nested_programs_end_nobody_who_reads_them(tmp_path: Path, name: str) -> None:
    """The readers run in a separate process: if Python itself crashes, one test fails instead of ending all tests."""
    path = tmp_path / "s1.py"
    path.write_text(DEEP[name])
    program = (
        "import sys, pathlib\n"
        "from workbook.exercise.answers import read_answer, syntax_mistake\n"
        "from workbook.typechecking.silencers import evasions, without_silencers\n"
        "text = read_answer(pathlib.Path(sys.argv[1]), sys.argv[2]).text\n"
        "mistake = syntax_mistake(text)\n"
        "assert mistake is None or mistake.message, mistake\n"
        "list(evasions(text)), without_silencers(text)\n"
        "print('alive')\n"
    )
    command = [sys.executable, "-c", program, str(path), STEM]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=40)
    assert done.stdout == "alive\n", (done.returncode, done.stderr[-500:])


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (notebook("print()"), "no cell that begins with"),
        (notebook("", ""), "no cell that begins with"),
        (notebook(f"%%answer {STEM}\n"), "the answer is empty"),
        (notebook("%%answer 05_timers\nprint()"), "answers 05_timers"),
        ("", "not a readable notebook"),
        ("[" * 100_000, "not a readable notebook"),
    ],
    ids=["no magic", "cleared", "empty answer", "another exercise", "empty file", "deep"],
)
def test_a_notebook_without_an_answer_is_told_why(tmp_path: Path, content: str, words: str) -> None:
    with pytest.raises(Ungradable, match=words):
        text_in(tmp_path, content)
