"""Hostile answers at the best tier: none earns what it should not, none leaves anything behind, none harms another."""

import json
import os
import re
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest

from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.exercise.judging import Judgement
from workbook.feedback.text import as_text
from workbook.grading.pool import Job, judge_all
from workbook.observing.sandbox import sandbox_problem

pytestmark = [pytest.mark.sandbox, pytest.mark.slow]
ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
FILES = sorted((Path(__file__).parent / "answers").glob("*.py"))
SLOTS = 2 * (os.cpu_count() or 1)
NEIGHBORS = 4
_HEADER = re.compile(r"^# (score|loses|says|limits): ?(.*)$")


@dataclass(frozen=True)
class Expected:
    """What the first lines of a hostile answer demand of its result."""

    score: float | None
    loses: frozenset[str]
    says: str
    limits: tuple[str, ...]


def expected_of(path: Path) -> Expected:
    found: dict[str, str] = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        header = _HEADER.match(line)
        if header is None:
            break
        found[header[1]] = header[2].strip()
    assert found.keys() & {"score", "loses"}, f"{path.name} says neither its score nor what it loses"
    return Expected(
        float(found["score"]) if "score" in found else None,
        frozenset(filter(None, found.get("loses", "").split(", "))),
        found.get("says", ""),
        tuple(filter(None, found.get("limits", "").split(", "))),
    )


@dataclass(frozen=True)
class Aftermath:
    """What came of all of them: the judgements, who called the listener, and what was left."""

    judgements: dict[str, Judgement]
    callers: int
    left_processes: list[str]
    left_files: set[str]


def processes_of_answers() -> dict[int, str]:
    """Processes whose command line names the host that runs answers, or a ghost that one of them started."""
    found = {}
    for entry in os.listdir("/proc"):
        if entry.isdigit() and int(entry) != os.getpid():
            try:
                command = (
                    Path(f"/proc/{entry}/cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace")
                )
            except OSError:
                continue
            if "/answer/" in command or 'create_node("ghost")' in command:
                found[int(entry)] = command
    return found


def files_around() -> set[str]:
    """Files of answers and graders in the common places, those of graders that still run left out."""
    found = set()
    for folder in ("/tmp", "/dev/shm"):
        for path in Path(folder).glob("*"):
            owner = re.match(r"rclpy-workbook-\d+-(\d+)-", path.name)
            ownerless = owner is not None and not Path(f"/proc/{owner[1]}").exists()
            if ownerless or path.name in ("results.json", "results.jsonl", "grades.csv", "rclpy.py"):
                found.add(str(path))
    return found


@pytest.fixture(scope="module")
def aftermath() -> Aftermath:
    problem = sandbox_problem()
    if problem is not None:
        pytest.skip(f"programs cannot be shut in: {problem}")
    solution = load_exercise(STEM, ROOT).source.solution_code
    eleven = (ROOT / "tests" / "wrong_answers" / STEM / "eleven_values.py").read_text(encoding="utf-8")
    listener = socket.create_server(("127.0.0.1", 0))
    callers: list[object] = []

    def listen() -> None:
        while True:
            try:
                connection, address = listener.accept()
            except OSError:
                return
            callers.append(address)
            connection.close()

    threading.Thread(target=listen, daemon=True).start()
    files = files_around()
    jobs = []
    for path in FILES:
        text = path.read_text(encoding="utf-8")
        for mark, code in (("@@GOOD@@", solution), ("@@ELEVEN@@", eleven), ("@@ROOT@@", str(ROOT))):
            text = text.replace(mark, code)
        jobs.append(Job(path.stem, STEM, Answer(text.replace("@@PORT@@", str(listener.getsockname()[1])))))
    step = max(1, len(jobs) // NEIGHBORS)
    for number in range(NEIGHBORS):
        jobs.insert(number * (step + 1), Job(f"neighbor {number}", STEM, Answer(solution)))
    os.environ["SECRET_OF_THE_GRADER"] = "1"
    try:
        judgements = {job.key: judgement for job, judgement in judge_all(jobs, SLOTS, isolation="sandbox")}
    finally:
        del os.environ["SECRET_OF_THE_GRADER"]
        listener.close()
    left = list(processes_of_answers().values())
    return Aftermath(judgements, len(callers), left, files_around() - files)


def test_a_killed_grader_takes_its_boxes_along_and_goes_on(tmp_path: Path) -> None:
    problem = sandbox_problem()
    if problem is not None:
        pytest.skip(f"programs cannot be shut in: {problem}")
    folder, out = tmp_path / "class", tmp_path / "out"
    folder.mkdir()
    for student in ("s1", "s2", "s3"):
        (folder / f"{student}.py").write_text(f"# {student}\nimport time\ntime.sleep(600)\n")
    command = [
        str(Path(sys.executable).with_name("workbook")), "grade", str(folder), "--exercise", STEM,
        "--out", str(out), "--slots", "3", "--isolation", "sandbox",
    ]  # fmt: skip
    before = set(processes_of_answers())
    grader = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        wait_until(lambda: len(set(processes_of_answers()) - before) >= 3)
    finally:
        grader.kill()
        grader.wait()
    wait_until(lambda: not set(processes_of_answers()) - before)
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    results = [json.loads(line) for line in (out / "results.jsonl").read_text().splitlines()]
    assert sorted(one["student"] for one in results) == ["s1", "s2", "s3"]
    assert {one["isolation"] for one in results} == {"sandbox"}


def wait_until(condition: Callable[[], bool]) -> None:
    deadline = time.monotonic() + 60.0
    while not condition():
        assert time.monotonic() < deadline, "waited a minute in vain"
        time.sleep(0.05)


def explained(judgement: Judgement) -> str:
    log = judgement.recording.process.log if judgement.recording is not None else ""
    return f"{judgement.reason}\n{as_text(judgement)}\n{log[-1500:]}"


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_hostile_answer_gets_what_it_earned(path: Path, aftermath: Aftermath) -> None:
    expected = expected_of(path)
    judgement = aftermath.judgements[path.stem]
    assert judgement.status == "graded", explained(judgement)
    if expected.score is not None:
        assert judgement.score == expected.score, explained(judgement)
    lost = {one.id for one in judgement.criteria if one.status in ("failed", "partial")}
    assert expected.loses <= lost, explained(judgement)
    if expected.says:
        told = " ".join(f"{one.saw} {one.because} {one.try_this}" for one in judgement.criteria)
        assert expected.says in told, explained(judgement)
    assert judgement.recording is not None
    assert set(expected.limits) <= set(judgement.recording.process.limits_hit), explained(judgement)


@pytest.mark.parametrize("number", range(NEIGHBORS))
def test_a_good_answer_among_them_keeps_its_marks(number: int, aftermath: Aftermath) -> None:
    judgement = aftermath.judgements[f"neighbor {number}"]
    assert judgement.full_marks, explained(judgement)


def test_nobody_got_out(aftermath: Aftermath) -> None:
    assert aftermath.callers == 0


def test_nothing_is_left(aftermath: Aftermath) -> None:
    assert aftermath.left_processes == []
    assert aftermath.left_files == set()


def test_no_log_holds_a_command(aftermath: Aftermath) -> None:
    for judgement in aftermath.judgements.values():
        assert judgement.recording is not None
        log = judgement.recording.process.log
        assert not re.search(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]", log)
