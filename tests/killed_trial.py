"""Kill the grader of a class of mixed answers repeatedly: `python -m tests.killed_trial [--seed 7]`.

The class is graded twice: once undisturbed, and once by a grader that is killed at random moments and started again.
Each answer must have one result, with the same points as in the undisturbed run. Every table must be the same except
for measured numbers, and no process or temporary file may stay behind.

The trial takes some minutes, so CI does not run it; there, `tests/hostile/test_killed_grader.py` kills a grader thirty
times.

The class has no programs that crash within their first moments. How much a busy machine records of those depends on
chance, even if no grader is killed. Each kill comes a random fraction of a second after a given number of results, so
that it interrupts the work on any machine.
"""

import argparse
import csv
import json
import os
import random
import re
import subprocess
import sys
import tempfile
import time
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tests.bench import wrong_answer
from tests.hostile.traces import Traces
from workbook.exercise.definition import load_exercise
from workbook.isolation.bubblewrap import sandbox_problem

ROOT = Path(__file__).resolve().parents[1]
STEM = "09_joint_positions"
TABLES = ("grades.csv", "canvas.csv", "moodle.csv", "nbgrader.csv")
RIGHT = (
    *("array_array", "base_class", "class_alone", "composition", "layout_filled", "main_never_called"),
    *("namespace_and_relative_names", "no_main_guard", "numpy_tolist", "one_timer", "whole_numbers"),
)
WRONG = (
    *("attribute_name_taken", "battery_renamed", "capital_letters", "eleven_values"),
    *("forgotten_init", "forgotten_spin", "import_error", "indentation_error", "init_twice"),
    *("json_in_a_string", "syntax_error", "thirteen_values", "wrong_name"),
)
HOSTILE = (
    "daemons_that_come_back",
    "exits_the_hard_way",
    "kills_everything",
    "leaves_a_publisher_behind",
    "loops_at_import",
)
_NUMBER = re.compile(r"-?\d+(\.\d+)?")
LATEST_S = 1.0
GONE_S = 120.0
LOOK_EVERY_S = 0.05


def texts(number: int) -> dict[str, str]:
    """Return `number` answers by student: right, wrong, and hostile ones in turn, no two alike."""
    right = ROOT / "tests" / "right_answers" / STEM
    hostile = Path(__file__).parent / "hostile" / "answers"
    solution = load_exercise(STEM, ROOT).source.solution_code
    kinds = {name: (right / f"{name}.py").read_text(encoding="utf-8") for name in RIGHT}
    kinds |= {name: wrong_answer(name).text for name in WRONG}
    for name in HOSTILE:
        text = (hostile / f"{name}.py").read_text(encoding="utf-8")
        kinds[name] = text.replace("@@GOOD@@", solution)
    names = [*kinds]
    return {
        f"s{one:02d}_{names[one % len(names)]}": f"{kinds[names[one % len(names)]]}\n# of student {one}\n"
        for one in range(number)
    }


@dataclass
class Trial:
    """One grading of the class. Its home and its temporary files are below `folder`."""

    folder: Path
    answers: Path
    slots: int

    def __post_init__(self) -> None:
        for name in ("home", "tmp"):
            (self.folder / name).mkdir(parents=True)
        self.traces = Traces(self.folder / "home")

    @property
    def out(self) -> Path:
        return self.folder / "out"

    def start(self) -> "subprocess.Popen[bytes]":
        """Start the grader, or start it again."""
        command = [
            *(sys.executable, "-m", "workbook.cli.main", "grade", str(self.answers), "--exercise", STEM),
            *("--out", str(self.out), "--slots", str(self.slots), "--isolation", "sandbox"),
            *("--format", "html,gradescope,canvas,moodle,nbgrader"),
        ]
        environ = {**os.environ, "HOME": str(self.folder / "home"), "TMPDIR": str(self.folder / "tmp")}
        environ.pop("XDG_CACHE_HOME", None)
        return subprocess.Popen(
            command, cwd=ROOT, env=environ, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )

    def complete(self) -> list[dict[str, Any]]:
        """Return the results that have been written."""
        path = self.out / "results.jsonl"
        lines = path.read_bytes().split(b"\n")[:-1] if path.exists() else []
        return [json.loads(line) for line in lines]

    def kill_at(self, results: int, later_s: float) -> bool:
        """Start the grader, and kill it after `results` results.

        Return whether it was still running when it was killed.
        """
        with self.start() as grader:
            while grader.poll() is None and len(self.complete()) < results:
                self.traces.look()
                time.sleep(LOOK_EVERY_S)
            try:
                grader.wait(later_s)
            except subprocess.TimeoutExpired:
                self.traces.look()
                grader.kill()
                return True
        return False

    def finish(self) -> int:
        """Let the grader finish. Return its exit code."""
        with self.start() as grader:
            while grader.poll() is None:
                self.traces.look()
                time.sleep(LOOK_EVERY_S)
        return grader.returncode

    def left(self) -> list[str]:
        """Wait a while, then return the processes and files that are still there."""
        until = time.monotonic() + GONE_S
        while (there := self.traces.look()) and time.monotonic() < until:
            time.sleep(LOOK_EVERY_S)
        files = [*self.traces.files(), *(self.folder / "tmp").iterdir()]
        return [*there.values(), *map(str, files)]

    def marks(self) -> dict[str, tuple[object, ...]]:
        """Return each student's status, score, and points by criterion."""
        return {
            one["student"]: (
                one["status"],
                one["score"],
                tuple((each["id"], each["status"], each["points"]) for each in one["criteria"]),
            )
            for one in self.complete()
        }


def rows_of(table: Path) -> list[list[str]]:
    """Return a table without the values that differ between any two runs.

    These are the numbers in feedback, the number of tries, and the remarks, which mention a busy machine.
    """
    with table.open(newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    kept = [number for number, name in enumerate(rows[0]) if name not in ("tries", "remark")]
    told = [number for number, name in enumerate(rows[0]) if name.endswith("(feedback)")]
    return [[_NUMBER.sub("0", row[one]) if one in told else row[one] for one in kept] for row in rows]


def differences(undisturbed: Trial, killed: Trial, students: set[str]) -> list[str]:
    """Return a sentence for each difference between the two gradings."""
    found = []
    counted = Counter(one["student"] for one in killed.complete())
    found += [f"{student} has {counted[student]} results" for student in students if counted[student] != 1]
    found += [f"{student} was never handed in" for student in counted.keys() - students]
    before, after = undisturbed.marks(), killed.marks()
    found += [
        f"{student}: {before.get(student)} undisturbed, {after.get(student)} killed"
        for student in sorted(students)
        if before.get(student) != after.get(student)
    ]
    for table in TABLES:
        both = [rows_of(trial.out / table) for trial in (undisturbed, killed)]
        found += [f"{table}: {one} and {other}" for one, other in zip(*both, strict=True) if one != other]
    for place in ("pages", "gradescope"):
        names = [
            sorted(path.name for path in (trial.out / place).iterdir()) for trial in (undisturbed, killed)
        ]
        if names[0] != names[1]:
            found.append(f"{place} holds other files")
    return found + [f"{path} is half-written" for path in killed.out.rglob("*.part")]


def main() -> int:
    """Run the trial and print the outcome. Return 1 if a result was lost or doubled, or if anything was left behind."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--answers", type=int, default=60)
    parser.add_argument("--kills", type=int, default=5)
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(1000))
    parser.add_argument("--slots", type=int, default=2)
    options = parser.parse_args()
    problem = sandbox_problem()
    if problem is not None:
        print(f"programs cannot be sandboxed: {problem}")
        return 2
    moments = random.Random(options.seed)
    with tempfile.TemporaryDirectory(prefix="killed-trial-") as folder:
        answers = Path(folder, "class")
        answers.mkdir()
        handed_in = texts(options.answers)
        for student, text in handed_in.items():
            (answers / f"{student}.py").write_text(text, encoding="utf-8")
        undisturbed = Trial(Path(folder, "undisturbed"), answers, options.slots)
        killed = Trial(Path(folder, "killed"), answers, options.slots)
        found = []
        began = time.monotonic()
        if undisturbed.finish() != 0:
            found.append("the undisturbed grader failed")
        print(f"seed {options.seed}; undisturbed: {time.monotonic() - began:.0f} s", flush=True)
        whens = sorted(moments.sample(range(options.answers * 5 // 6), options.kills))
        for results in whens:
            later_s = moments.random() * LATEST_S
            hit = killed.kill_at(results, later_s)
            left = killed.left()
            print(f"killed {later_s:.2f} s after {results} results: {'in the middle' if hit else 'too late'}")
            found += [] if hit else ["a grader was done before it was killed"]
            found += [f"left behind: {one}" for one in left]
        if killed.finish() != 0:
            found.append("the grader that was started again failed")
        found += [f"left behind: {one}" for one in killed.left()]
        found += differences(undisturbed, killed, set(handed_in))
        scores = Counter(str(one["score"]) for one in killed.complete())
    print("\n".join(found) or f"each of {options.answers} answers has one result, all tables are equal")
    print("scores:", ", ".join(f"{score}: {number}" for score, number in scores.most_common()))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
