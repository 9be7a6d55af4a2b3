"""The autograder for Gradescope: packed, unpacked, and run as on Gradescope, but in this environment."""

import contextlib
import json
import os
import shutil
import signal
import stat
import subprocess
import sys
import zipfile
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from tests.programs.support import wait_until
from workbook.authoring.tree import Tree
from workbook.authoring.wrong_answers import read_wrong_answer
from workbook.cli.main import main
from workbook.exercise.definition import load_exercise
from workbook.exercise.source import load
from workbook.exercise.source import stems as stems_in
from workbook.exercise.without_solution import without_solution
from workbook.inside.proc import process_tree
from workbook.isolation.bubblewrap import sandbox_problem

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
SOLUTION = (ROOT / "solutions" / f"{STEM}.py").read_text(encoding="utf-8")
ELEVEN = read_wrong_answer(Tree(ROOT), Tree(ROOT).wrong_answers / STEM / "eleven_values.py").answer.text
VISIBILITY = {"hidden", "after_due_date", "after_published", "visible"}
FORMATS = {"text", "html", "simple_format", "md", "ansi"}
OF_RESULTS = {
    "score", "execution_time", "output", "output_format", "test_output_format", "test_name_format", "visibility",
    "stdout_visibility", "extra_data", "tests", "leaderboard",
}  # fmt: skip
OF_TESTS = {
    "score", "max_score", "status", "name", "name_format", "number", "output", "output_format", "tags",
    "visibility", "extra_data",
}  # fmt: skip


def check_rules(data: Mapping[str, Any]) -> None:
    """Check Gradescope's rules for results.json, according to its specification."""
    assert set(data) <= OF_RESULTS
    assert isinstance(data.get("output", ""), str)
    assert isinstance(data.get("execution_time", 0), int)
    assert data.get("visibility", "visible") in VISIBILITY
    assert data.get("stdout_visibility", "visible") in VISIBILITY
    for name in ("output_format", "test_output_format", "test_name_format"):
        assert data.get(name, "text") in FORMATS
    for test in data["tests"]:
        assert set(test) <= OF_TESTS
        assert test["status"] in ("passed", "failed")
        assert 0 <= test["score"] <= test["max_score"]
        assert isinstance(test["number"], str)
        assert test["visibility"] in VISIBILITY
        assert {test["name_format"], test["output_format"]} <= FORMATS
    has_score = "score" in data or bool(data["tests"])
    if data["extra_data"]["status"] == "infra_error":
        assert not has_score, "a fault of ours must not become a score"
        assert "infra_error" in data["output"]
        assert "no points are lost" in data["output"]
    else:
        assert has_score
        if "score" in data:
            assert data["score"] == sum(test["score"] for test in data["tests"])


# --- the zip --------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    target = tmp_path_factory.mktemp("package") / "autograder.zip"
    assert main(["package", "gradescope", "joint_positions", "--out", str(target)]) == 0
    return target


def test_the_same_course_gives_the_same_bytes(package: Path, tmp_path: Path) -> None:
    again = tmp_path / "other name.zip"
    stray = ROOT / "workbook" / "grading" / "gradescope_files" / "__pycache__"
    stray.mkdir()
    try:
        (stray / "stray.pyc").write_bytes(b"what a tool left")
        assert main(["package", "gradescope", STEM, "--out", str(again)]) == 0
    finally:
        (stray / "stray.pyc").unlink()
        stray.rmdir()
    assert again.read_bytes() == package.read_bytes()
    assert not list(tmp_path.glob(".*"))


def test_it_holds_what_gradescope_wants_and_no_other_exercise(package: Path) -> None:
    with zipfile.ZipFile(package) as archive:
        modes = {entry.filename: entry.external_attr >> 16 for entry in archive.infolist()}
        texts = {name: archive.read(name).decode("utf-8", "replace") for name in archive.namelist()}
    for name in ("setup.sh", "run_autograder"):
        assert stat.S_IMODE(modes[name]) == 0o755
        assert texts[name].startswith("#!/usr/bin/env bash\n")
        assert subprocess.run(["bash", "-n"], input=texts[name], text=True).returncode == 0
    assert f'exercise="{STEM}"' in texts["run_autograder"]
    assert "@EXERCISE@" not in texts["run_autograder"]
    exercises = {name for name in texts if name.startswith(("course/exercises/", "course/solutions/"))}
    criteria = (ROOT / "exercises" / "criteria").glob(f"{STEM}.*")
    assert exercises == {
        f"course/solutions/{STEM}.py",
        *(f"course/exercises/criteria/{path.name}" for path in criteria),
    }
    for catalog in (ROOT / "workbook" / "criteria").rglob("*.toml"):
        assert f"course/{catalog.relative_to(ROOT).as_posix()}" in texts
    assert not [name for name in texts if "__pycache__" in name or "/tests/" in name or "/.venv/" in name]
    assert "course/requirements.lock" in texts


def test_the_solution_stays_at_home(package: Path) -> None:
    source = load_exercise(STEM, ROOT).source
    given = set(source.starter_code.splitlines())
    secret = [line for line in source.solution_code.splitlines() if line.strip() and line not in given]
    assert len(secret) > 3
    with zipfile.ZipFile(package) as archive:
        packed = archive.read(f"course/solutions/{STEM}.py").decode()
    assert not [line for line in secret if line in packed.splitlines()]


@pytest.mark.parametrize("stem", stems_in(ROOT / "solutions"))
def test_what_a_grader_needs_of_a_source_is_there_without_its_solution(stem: str, tmp_path: Path) -> None:
    whole = load(ROOT / "solutions" / f"{stem}.py")
    path = tmp_path / f"{stem}.py"
    path.write_text(without_solution(whole, hints=False), encoding="utf-8")
    reduced = load(path)
    for name in ("stem", "title", "kind", "clock", "minutes", "difficulty"):
        assert getattr(reduced, name) == getattr(whole, name)
    assert reduced.solution_code == whole.starter_code


def test_own_criteria_are_packed_and_missing_ones_are_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.delenv("WORKBOOK_CRITERIA", raising=False)
    monkeypatch.setenv("WORKBOOK_CRITERIA", "")
    own, target = tmp_path / "own", tmp_path / "a.zip"
    command = ["package", "gradescope", STEM, "--out", str(target), "--criteria", str(own)]
    assert main(command) == 2
    assert "there is no such folder" in capsys.readouterr().err
    own.mkdir()
    assert main(command) == 2
    assert f"has no {STEM}.py" in capsys.readouterr().err
    assert not target.exists()
    (own / f"{STEM}.py").write_bytes((ROOT / "exercises" / "criteria" / f"{STEM}.py").read_bytes())
    assert main(command) == 0
    with zipfile.ZipFile(target) as archive:
        assert f"course/own_criteria/{STEM}.py" in archive.namelist()


# --- a submission ---------------------------------------------------------------------------------------------------


class Gradescope:
    """Does what Gradescope does: unpack the zip into source/, and run run_autograder on the files in submission/."""

    def __init__(self, root: Path, package: Path) -> None:
        self.root = root
        subprocess.run(
            [sys.executable, "-m", "zipfile", "-e", str(package), str(root / "source")], check=True
        )
        self.course = root / "source" / "course"
        self.script = root / "run_autograder"
        self.script.write_bytes((root / "source" / "run_autograder").read_bytes())
        self.script.chmod(0o755)
        (root / "submission").mkdir()
        (root / "results").mkdir()

    def submit(self, **files: str) -> None:
        for name, text in files.items():
            path = self.root / "submission" / name.replace("__", ".")
            path.write_text(text, encoding="utf-8")

    def environ(self, **more: str) -> dict[str, str]:
        return {
            "PATH": os.environ["PATH"],
            "HOME": os.environ.get("HOME", "/"),
            "AUTOGRADER_ROOT": str(self.root),
            "AUTOGRADER_PYTHON": sys.executable,
            **more,
        }

    def run(self, **more: str) -> dict[str, Any]:
        self.done = subprocess.run(
            [self.script], env=self.environ(**more), cwd=self.root, capture_output=True, text=True
        )
        return self.results()

    def results(self) -> dict[str, Any]:
        data = json.loads((self.root / "results" / "results.json").read_text())
        check_rules(data)
        assert not list((self.root / "results").glob("*.part"))
        return dict(data)


@pytest.fixture
def scope(tmp_path: Path, package: Path) -> Gradescope:
    return Gradescope(tmp_path / "autograder", package)


@pytest.fixture(scope="module")
def judged(package: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, dict[str, Any]]:
    """Run two submissions in parallel: a right answer and a wrong one."""
    scopes = {name: Gradescope(tmp_path_factory.mktemp(name), package) for name in ("right", "wrong")}
    init = scopes["right"].course / "workbook" / "__init__.py"
    init.write_text(init.read_text() + '\n__version__ = "as it was packed"\n')
    scopes["right"].submit(node__py=SOLUTION)
    scopes["wrong"].submit(node__py=ELEVEN, notes__txt="x")
    with ThreadPoolExecutor(2) as pool:
        found = dict(zip(scopes, pool.map(lambda scope: scope.run(), scopes.values()), strict=True))
    for scope in scopes.values():
        assert scope.done.returncode == 0, scope.done.stderr
    return found


@pytest.mark.slow
def test_a_right_answer_has_full_marks_from_the_packed_course(judged: dict[str, dict[str, Any]]) -> None:
    data = judged["right"]
    assert data["score"] == 10
    assert {test["status"] for test in data["tests"]} == {"passed"}
    assert data["extra_data"]["versions"]["workbook"] == "as it was packed"


@pytest.mark.slow
def test_a_wrong_answer_loses_what_it_should_and_hears_why(judged: dict[str, dict[str, Any]]) -> None:
    data = judged["wrong"]
    assert data["score"] == 9
    [failed] = [test for test in data["tests"] if test["status"] == "failed"]
    assert "11 values" in failed["output"]
    assert "try: " in failed["output"]
    assert "11 values" in data["output"]


@pytest.mark.slow
def test_the_best_tier_is_taken_and_told(judged: dict[str, dict[str, Any]]) -> None:
    best = "sandbox" if sandbox_problem() is None else None
    for data in judged.values():
        tier = data["extra_data"]["isolation"]
        assert f"Isolation: {tier} (the program ran " in data["output"]
        assert best is None or tier == best


@pytest.mark.slow
@pytest.mark.whole
def test_without_bubblewrap_it_takes_the_best_of_the_rest_and_says_so(scope: Gradescope) -> None:
    tools = scope.root / "tools"
    tools.mkdir()
    for name in ("bash", "env", "mkdir", "mv", "sh", "timeout"):
        found = shutil.which(name)
        assert found is not None
        (tools / name).symlink_to(found)
    scope.submit(node__py=SOLUTION)
    data = scope.run(PATH=str(tools))
    assert data["score"] == 10, scope.done.stderr
    tier = data["extra_data"]["isolation"]
    assert tier in ("uid", "landlock", "limits")
    assert f"Isolation: {tier}" in data["output"]


@pytest.mark.whole
@pytest.mark.parametrize(
    ("files", "says"),
    [
        ({}, "holds no .py and no .ipynb"),
        ({"node__py": ""}, "the answer is empty"),
        ({"node__py": SOLUTION, "other__py": SOLUTION}, "2 files could be the answer"),
        ({"node__ipynb": "{}"}, "not a readable notebook"),
    ],
    ids=["nothing", "empty", "two files", "no notebook"],
)
def test_what_cannot_be_judged_is_told_to_the_student(
    files: dict[str, str], says: str, scope: Gradescope
) -> None:
    scope.submit(**files)
    data = scope.run()
    assert scope.done.returncode == 0
    assert data["extra_data"]["status"] == "ungradable"
    [test] = data["tests"]
    assert (test["score"], test["max_score"], test["status"], test["visibility"]) == (
        0,
        10,
        "failed",
        "visible",
    )
    assert says in test["output"]
    assert "Submit again" in test["output"]
    assert says in data["output"]


@pytest.mark.whole
def test_a_missing_submission_folder_is_nothing_handed_in(scope: Gradescope) -> None:
    (scope.root / "submission").rmdir()
    assert "nothing was handed in" in scope.run()["output"]


# --- our own faults -------------------------------------------------------------------------------------------------


@pytest.mark.whole
def test_criteria_that_do_not_import_cost_nobody_a_point(scope: Gradescope) -> None:
    scope.submit(node__py=SOLUTION)
    (scope.course / "exercises" / "criteria" / f"{STEM}.py").write_text("import rclpie\n")
    data = scope.run()
    assert "rclpie" in data["output"]
    assert scope.done.returncode != 0


@pytest.mark.whole
@pytest.mark.parametrize(
    ("python", "says"),
    [
        ("exit 1", "ended with code 1)"),
        ("kill -9 $$", "was killed"),
        ("exit 0", "ended before it was done"),
        (None, "ended with code 127"),
    ],
    ids=["crash", "killed", "silent", "no python"],
)
def test_a_grader_that_fails_leaves_a_result_that_says_so(
    python: str | None, says: str, scope: Gradescope
) -> None:
    scope.submit(node__py=SOLUTION)
    stand_in = scope.root / "python"
    if python is not None:
        stand_in.write_text(f"#!/bin/sh\n{python}\n")
        stand_in.chmod(0o755)
    assert says in scope.run(AUTOGRADER_PYTHON=str(stand_in))["output"]


def hosts(scope: Gradescope) -> list[int]:
    """Return the processes that run an answer, or a sandbox around one, for this autograder."""
    inside = f"{scope.course}/workbook/inside"
    needles = (f"{inside}/host.py".encode(), f"{inside}/run.py\0host".encode())
    found = []
    for entry in os.listdir("/proc"):
        try:
            command = Path(f"/proc/{entry}/cmdline").read_bytes() if entry.isdigit() else b""
            if any(needle in command for needle in needles):
                found.append(int(entry))
        except OSError:
            continue
    return found


ENDLESS = "import time\ntime.sleep(600)\n"


@pytest.mark.whole
@pytest.mark.slow
def test_time_out_is_told_and_leaves_no_process(scope: Gradescope) -> None:
    scope.submit(node__py=ENDLESS)
    data = scope.run(AUTOGRADER_SECONDS="6")
    assert "more than 6 seconds" in data["output"]
    wait_until(lambda: not hosts(scope))


@pytest.mark.whole
@pytest.mark.slow
def test_a_result_is_there_when_everything_is_killed_at_once(scope: Gradescope) -> None:
    scope.submit(node__py=ENDLESS)
    process = subprocess.Popen(
        [scope.script],
        env=scope.environ(),
        cwd=scope.root,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        wait_until(lambda: hosts(scope))
    finally:
        for pid in process_tree(process.pid):
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        process.wait()
    assert "ended before it was done" in scope.results()["output"]
    wait_until(lambda: not hosts(scope))
