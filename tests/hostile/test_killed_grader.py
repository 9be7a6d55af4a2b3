"""A grader killed thirty times at random moments leaves nothing behind, and each student gets one result."""

import csv
import json
import os
import random
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import pytest

from tests.hostile.traces import Traces
from tests.programs.support import wait_until
from workbook.isolation.bubblewrap import sandbox_problem

pytestmark = [pytest.mark.sandbox, pytest.mark.slow, pytest.mark.whole]
STEM = "09_joint_positions"
KILLS = 30
KILLS_PER_CLASS = 10
MOST_CLASSES = 100
STUDENTS = 10


@dataclass
class Grading:
    """A class, and the command that grades it with one or two slots."""

    folder: Path
    slots: int = 2

    def __post_init__(self) -> None:
        answers = self.folder / "class"
        answers.mkdir(parents=True)
        (self.folder / "home").mkdir()
        (self.folder / "tmp").mkdir()
        for number in range(STUDENTS - 2):
            (answers / f"s{number}.py").write_text(f"robot = = {number}\n")
        (answers / "daemon.py").write_text(
            "import os, time\nif os.fork() == 0:\n    os.setsid()\n    time.sleep(600)\ntime.sleep(0.3)\n"
        )
        (answers / "empty.py").write_text("")
        self.traces = Traces(self.folder / "home")

    @property
    def out(self) -> Path:
        return self.folder / "out"

    def start(self) -> "subprocess.Popen[bytes]":
        """Start the grader with a folder for its temporary files that no other process uses."""
        return subprocess.Popen(
            [
                *(sys.executable, "-m", "workbook.cli.main", "grade", str(self.folder / "class")),
                *(
                    "--exercise",
                    STEM,
                    "--out",
                    str(self.out),
                    "--slots",
                    str(self.slots),
                    "--isolation",
                    "sandbox",
                ),
            ],
            env={**os.environ, "HOME": str(self.folder / "home"), "TMPDIR": str(self.folder / "tmp")},
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
        )

    def results(self) -> list[str]:
        """Return the students with a result, one per line of the results."""
        path = self.out / "results.jsonl"
        lines = path.read_bytes().split(b"\n")[:-1] if path.exists() else []
        return [json.loads(line)["student"] for line in lines]

    def assert_nothing_is_left(self) -> None:
        look = self.traces.look
        wait_until(lambda: not look(), "the processes of the killed grader end", instead=look)
        files = self.traces.files
        wait_until(
            lambda: not files(), "what removes the memory cgroup of a killed grader is done", instead=files
        )
        assert os.listdir(self.folder / "tmp") == []


def finish(grading: Grading) -> float:
    """Let a grader finish, check that each student has one result, and return how long it took (s)."""
    began = time.monotonic()
    with grading.start() as grader:
        assert grader.stderr is not None
        said = grader.stderr.read().decode()
    took = time.monotonic() - began
    assert grader.returncode == 0, said
    students = sorted([*(f"s{number}" for number in range(STUDENTS - 2)), "daemon", "empty"])
    assert sorted(grading.results()) == students
    with (grading.out / "grades.csv").open(encoding="utf-8-sig", newline="") as file:
        assert [row["student"] for row in csv.DictReader(file)] == students
    left = [path.name for path in grading.out.rglob("*") if path.name.endswith(".part")]
    assert left == [], "half-written files"
    grading.assert_nothing_is_left()
    return took


def test_a_grader_killed_at_any_moment_leaves_nothing_and_loses_nothing(tmp_path: Path) -> None:
    problem = sandbox_problem()
    if problem is not None:
        pytest.skip(f"programs cannot be sandboxed: {problem}")
    whole_run = finish(Grading(tmp_path / "whole"))
    moments = random.Random(4)
    kills = killed_at_work = 0
    for number in range(MOST_CLASSES):  # one class is enough for several kills, unless grading ends before
        grading = Grading(tmp_path / f"class {number}", slots=1 + number % 2)
        for _ in range(KILLS_PER_CLASS):
            if kills == KILLS:
                break
            moment = moments.random() * whole_run
            with grading.start() as grader:
                try:
                    grader.wait(moment)
                    whole_run = min(whole_run, moment)  # the machine is less busy than before
                    break  # grading has ended, so there is nothing left to kill in this class
                except subprocess.TimeoutExpired:
                    grading.traces.look()
                    killed_at_work += bool(grading.traces.look().keys() - {grader.pid})
                    grader.kill()
            kills += 1
            grading.assert_nothing_is_left()
        finish(grading)
        if kills == KILLS:
            break
    assert kills == KILLS
    assert killed_at_work >= KILLS // 3, "most moments were before the first slot"
