"""Grade a class: results are kept, only changed answers run again, and a kill at any moment loses nothing."""

import csv
import json
import os
import signal
import subprocess
import sys
import threading
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from tests.programs.support import CLIMB, is_gone, wait_until
from workbook.cli.grade_screen import conclude
from workbook.exercise.answers import Answer
from workbook.exercise.definition import Exercise, load_exercise
from workbook.exercise.judgement import Judgement, judge_recording
from workbook.grading.batch import Batch, BatchProgress, BatchSummary
from workbook.grading.judges import Job
from workbook.grading.results import Result
from workbook.grading.results_file import read_results
from workbook.grading.slots import pool, scheduler
from workbook.grading.slots.client import Slot
from workbook.grading.slots.scheduler import LocalSlots, judge_all
from workbook.inside.proc import process_tree
from workbook.recording.recording import Recording

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
UNREADABLE = "speed = = 3\n"


@pytest.fixture
def exercise() -> Exercise:
    return load_exercise(STEM, ROOT)


# --- which answers run, tested without running any ----------------------------------------------------------------


class ScriptedBackend:
    """Replaces the slots: notes which answers it should judge, and gives each student a stored recording."""

    def __init__(self, exercise: Exercise) -> None:
        self.exercise = exercise
        self.asked: list[str] = []
        self.ours_to_blame: set[str] = set()
        recording = Recording.load(ROOT / "tests" / "recordings" / STEM / "eleven_values.json")
        self.judgement = judge_recording(exercise, "", recording)

    def __call__(
        self,
        jobs: Iterable[Job[Any]],
        slots: int,
        *,
        soak: bool = True,
        isolation: str = "limits",
        stop: Callable[[], bool] = lambda: False,
        fills: bool = False,
    ) -> Iterator[tuple[Job[Any], Judgement]]:
        for job in jobs:
            if stop():
                return
            self.asked.append(job.key.student)
            if job.key.student in self.ours_to_blame:
                yield job, Judgement(job.stem, job.answer.sha256, "infra_error", "the slot is gone", (), None)
            else:
                yield job, replace(self.judgement, answer_sha256=job.answer.sha256)


@pytest.fixture
def judges(exercise: Exercise, monkeypatch: pytest.MonkeyPatch) -> ScriptedBackend:
    judges = ScriptedBackend(exercise)
    monkeypatch.setattr(scheduler, "judge_all", judges)
    return judges


@pytest.fixture
def hand_ins(tmp_path: Path) -> Path:
    folder = tmp_path / "class"
    folder.mkdir()
    for number in range(4):
        (folder / f"s{number}.py").write_text(f"robot = {number}\n")
    (folder / "s4.py").write_text("")
    return folder


def lines(out: Path) -> list[Result]:
    return list(read_results(out / "results.jsonl"))


def grade(exercise: Exercise, hand_ins: Path, **options: Any) -> BatchSummary:
    return Batch(exercise, hand_ins.parent / "out", LocalSlots(2)).run([hand_ins], **options)


def test_everybody_gets_one_result(exercise: Exercise, hand_ins: Path, judges: ScriptedBackend) -> None:
    seen: list[BatchProgress] = []
    summary = grade(exercise, hand_ins, progress=seen.append)
    assert judges.asked == ["s0", "s1", "s2", "s3"]
    assert Counter(result.status for result in summary.results) == {"graded": 4, "ungradable": 1}
    assert [result.student for result in summary.results] == ["s0", "s1", "s2", "s3", "s4"]
    assert (summary.judged, summary.kept, summary.stopped) == (5, 0, False)
    assert [progress.done for progress in seen] == [1, 2, 3, 4, 5]
    assert {progress.total for progress in seen} == {5}
    assert seen[0].left_s is None
    assert seen[-1].left_s == 0
    assert (hand_ins.parent / "out" / "grades.csv").read_text("utf-8-sig").count("\n") == 6


def test_a_second_run_runs_nothing(exercise: Exercise, hand_ins: Path, judges: ScriptedBackend) -> None:
    grade(exercise, hand_ins)
    before = lines(hand_ins.parent / "out")
    judges.asked.clear()
    summary = grade(exercise, hand_ins)
    assert judges.asked == []
    assert (summary.kept, summary.judged, len(summary.results)) == (5, 0, 5)
    assert lines(hand_ins.parent / "out") == before


def test_a_changed_answer_runs_again_as_another_attempt(
    exercise: Exercise, hand_ins: Path, judges: ScriptedBackend
) -> None:
    grade(exercise, hand_ins)
    judges.asked.clear()
    (hand_ins / "s2.py").write_text("robot = 'changed'\n")
    (hand_ins / "s4.py").write_text("robot = 'there at last'\n")
    summary = grade(exercise, hand_ins)
    assert judges.asked == ["s2", "s4"]
    assert [(one.student, one.attempt) for one in lines(hand_ins.parent / "out")][5:] == [
        ("s2", 2),
        ("s4", 2),
    ]
    assert {one.student: one.attempt for one in summary.results} == {
        "s0": 1,
        "s1": 1,
        "s2": 2,
        "s3": 1,
        "s4": 2,
    }


def test_other_line_ends_are_no_change(exercise: Exercise, hand_ins: Path, judges: ScriptedBackend) -> None:
    grade(exercise, hand_ins)
    judges.asked.clear()
    (hand_ins / "s2.py").write_bytes(b"robot = 2\r\n")
    assert grade(exercise, hand_ins).kept == 5
    assert judges.asked == []


def test_changed_criteria_change_no_mark(
    exercise: Exercise, hand_ins: Path, judges: ScriptedBackend, capsys: pytest.CaptureFixture[str]
) -> None:
    grade(exercise, hand_ins)
    before = lines(hand_ins.parent / "out")
    judges.asked.clear()
    newer = replace(exercise, criteria_sha256="c" * 64)
    summary = grade(newer, hand_ins)
    assert judges.asked == []
    assert lines(hand_ins.parent / "out") == before
    assert (summary.kept, summary.frozen) == (5, 5)
    conclude(summary, hand_ins.parent / "out", [])
    assert "5 of these kept their marks although the criteria have changed since." in capsys.readouterr().out
    (hand_ins / "s2.py").write_text("robot = 'changed'\n")
    summary = grade(newer, hand_ins)
    assert judges.asked == ["s2"]
    assert (summary.kept, summary.frozen) == (4, 4)
    judged_by = {one.student: one.versions.criteria for one in summary.results}
    assert judged_by.pop("s2") == "c" * 64
    assert set(judged_by.values()) == {exercise.criteria_sha256}


def test_nothing_is_said_of_frozen_marks_where_the_criteria_are_the_same(
    exercise: Exercise, hand_ins: Path, judges: ScriptedBackend, capsys: pytest.CaptureFixture[str]
) -> None:
    grade(exercise, hand_ins)
    summary = grade(exercise, hand_ins)
    conclude(summary, hand_ins.parent / "out", [])
    assert "--regrade" not in capsys.readouterr().out


def test_a_fault_of_ours_runs_again(exercise: Exercise, hand_ins: Path, judges: ScriptedBackend) -> None:
    judges.ours_to_blame = {"s1"}
    summary = grade(exercise, hand_ins)
    assert {one.student: one.score for one in summary.results}["s1"] is None
    judges.ours_to_blame.clear()
    judges.asked.clear()
    summary = grade(exercise, hand_ins)
    assert judges.asked == ["s1"]
    assert {one.student: one.score for one in summary.results}["s1"] == 9


def test_a_stopped_run_goes_on(exercise: Exercise, hand_ins: Path, judges: ScriptedBackend) -> None:
    summary = grade(exercise, hand_ins, stop=lambda: len(judges.asked) >= 2)
    assert summary.stopped
    assert judges.asked == ["s0", "s1"]
    judges.asked.clear()
    assert not grade(exercise, hand_ins).stopped
    assert judges.asked == ["s2", "s3"]


def test_a_torn_line_runs_that_student_again(
    exercise: Exercise, hand_ins: Path, judges: ScriptedBackend
) -> None:
    grade(exercise, hand_ins)
    judges.asked.clear()
    path = hand_ins.parent / "out" / "results.jsonl"
    path.write_bytes(path.read_bytes()[:-40])
    grade(exercise, hand_ins)
    assert judges.asked == ["s3"]
    assert Counter(one.student for one in lines(path.parent)) == {f"s{n}": 1 for n in range(5)}


def test_the_hour_of_submission_is_kept(exercise: Exercise, tmp_path: Path, judges: ScriptedBackend) -> None:
    folder = tmp_path / "course" / "submitted" / "s1042" / STEM
    folder.mkdir(parents=True)
    (folder / "answer.py").write_text("robot = 1\n")
    (folder / "timestamp.txt").write_text("2025-01-31 23:59:00 UTC\n")
    [result] = Batch(exercise, tmp_path / "out", LocalSlots(1)).run([tmp_path / "course"]).results
    assert result.submitted_at == "2025-01-31 23:59:00 UTC"
    assert result.answer == f"s1042/{STEM}/answer.py"


def test_a_course_of_nbgrader_is_graded_and_goes_back_into_its_gradebook(
    tmp_path: Path, judges: ScriptedBackend, capsys: pytest.CaptureFixture[str]
) -> None:
    from workbook.cli.main import main

    for student, folder in (("ada", "ps2/deep"), ("bob", "ps2"), ("eve", "ps1")):
        place = tmp_path / "course" / "submitted" / student / folder
        place.mkdir(parents=True)
        (place / "problem.py").write_text(f"robot = {student!r}\n")
        (tmp_path / "course" / "submitted" / student / folder.split("/")[0] / "timestamp.txt").write_text(
            "2025-01-31 23:59:00 UTC\n"
        )
    out = tmp_path / "out"
    command = [
        "grade",
        str(tmp_path / "course"),
        "--exercise",
        STEM,
        "--assignment",
        "ps2",
        "--out",
        str(out),
    ]
    assert main([*command, "--isolation", "limits", "--format", "nbgrader"]) == 0, capsys.readouterr()
    rows = {row["student_id"]: row for row in csv.DictReader((out / "nbgrader.csv").open(newline=""))}
    assert {name: (row["assignment"], row["score"]) for name, row in rows.items()} == {
        "ada": ("ps2", "9"), "bob": ("ps2", "9"), "eve": ("ps2", ""),
    }  # fmt: skip
    assert rows["ada"]["timestamp"] == rows["bob"]["timestamp"] == "2025-01-31 23:59:00 UTC"
    assert "eve: ungradable: there is no folder ps2" in capsys.readouterr().out
    assert main([*command[:-3], "../ps2", "--out", str(out), "--isolation", "limits"]) == 2
    assert "give the name of a folder" in capsys.readouterr().err


def test_lateness_is_taken_off_in_the_gradebook_and_who_has_no_time_is_named(
    tmp_path: Path, judges: ScriptedBackend, capsys: pytest.CaptureFixture[str]
) -> None:
    from workbook.cli.main import main

    for student, stamp in (
        ("ada", "2025-01-31 23:59:00.5 UTC\n"),
        ("bob", "2025-02-01 00:01:00.5 UTC\n"),
        ("eve", ""),
    ):
        place = tmp_path / "class" / student
        place.mkdir(parents=True)
        (place / "problem.py").write_text(f"robot = {student!r}\n")
        (place / "timestamp.txt").write_text(stamp)
    out = tmp_path / "out"
    command = [
        "grade",
        str(tmp_path / "class"),
        "--exercise",
        STEM,
        "--out",
        str(out),
        "--isolation",
        "limits",
    ]
    command += ["--deadline", "2025-02-01T00:00+00:00", "--late-per-day", "0.1"]
    for _ in range(2):  # the second time, all results exist already
        assert main(command) == 0, capsys.readouterr()
        rows = {
            row["student"]: row["score"]
            for row in csv.DictReader((out / "grades.csv").open(encoding="utf-8-sig", newline=""))
        }
        assert rows == {"ada": "9", "bob": "8", "eve": "9"}
        assert "1 of 3 (eve)" in capsys.readouterr().out


def test_odd_hand_ins_are_ungradable_and_hang_nothing(
    exercise: Exercise, tmp_path: Path, judges: ScriptedBackend
) -> None:
    folder = tmp_path / "class"
    folder.mkdir()
    (folder / "endless.py").symlink_to("/dev/zero")
    os.mkfifo(folder / "pipe.py")
    (folder / "dangling.ipynb").symlink_to("nowhere")
    (folder / os.fsdecode(b"m\xfcller.py")).write_text("robot = 1\n")
    (folder / "half.ipynb").write_text(
        '{"cells": [{"cell_type": "code", "source": "%%answer 09_joint_positions\\nx = \'\\ud83d\'"}]}'
    )
    (folder / "two").mkdir()
    for name in ("a.py", "b.py"):
        (folder / "two" / name).write_text("robot = 1\n")
    summary = grade(exercise, folder)
    status = {one.student: one.status for one in summary.results}
    assert status == {
        "dangling": "ungradable",
        "endless": "ungradable",
        "half": "ungradable",
        "m\\xfcller": "graded",
        "pipe": "ungradable",
        "two": "ungradable",
    }
    assert all(one.reason for one in summary.results if one.status == "ungradable")
    assert grade(exercise, folder).kept == 6


# --- real slots -----------------------------------------------------------------------------------------------------


def once(marks: Path, first: str) -> str:
    """Return an answer that runs `first` the first time; later, it ends right away."""
    return f"""\
{CLIMB}
import subprocess
marks = {str(marks)!r}
if os.path.exists(marks):
    raise SystemExit(3)
daemon = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(600)"], start_new_session=True)
with open(marks + ".part", "w") as file:
    print(judge(), os.getpid(), daemon.pid, file=file)
os.rename(marks + ".part", marks)
{first}
"""


def pids_in(marks: Path) -> list[int]:
    wait_until(marks.exists)
    return [int(word) for word in marks.read_text().split()]


def workbook(*arguments: object) -> "subprocess.Popen[str]":
    return subprocess.Popen(
        [sys.executable, "-m", "workbook.cli.main", *map(str, arguments)],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def test_a_killed_grader_goes_on_and_leaves_no_process(tmp_path: Path) -> None:
    folder, out, marks = tmp_path / "class", tmp_path / "out", tmp_path / "marks"
    folder.mkdir()
    for student in ("s1", "s2", "s4"):
        (folder / f"{student}.py").write_text(UNREADABLE + f"# {student}\n")
    (folder / "s3.py").write_text(once(marks, "time.sleep(600)"))
    (folder / "s5.py").write_text("")
    command = ("grade", folder, "--exercise", "joint_positions", "--out", out, "--slots", "1")
    command += ("--isolation", "limits")  # a sandboxed answer could not leave its mark

    with workbook(*command) as grader:
        judged = pids_in(marks)
        everything = {*judged, *process_tree(grader.pid)}
        assert not any(map(is_gone, (*judged, grader.pid)))  # other processes may have ended by now
        wait_until(lambda: len(lines(out)) == 3)  # the result of s2 is written while s3 is already running
        grader.kill()
        wait_until(lambda: all(map(is_gone, everything - {grader.pid})))
    first = lines(out)
    assert [one.student for one in first] == ["s5", "s1", "s2"]
    with (out / "results.jsonl").open("a") as file:
        file.write('{"student": "s3", "exercise": "09_joi')

    with workbook(*command) as grader:
        said, progress = grader.communicate()
    assert grader.returncode == 0, progress
    results = lines(out)
    assert results[:3] == first
    assert Counter(one.student for one in results) == {f"s{n}": 1 for n in range(1, 6)}
    assert {one.student: one.status for one in results} == {
        "s1": "graded",
        "s2": "graded",
        "s3": "graded",
        "s4": "graded",
        "s5": "ungradable",
    }
    assert {one.score for one in results} == {0, None}
    assert "5 answers: 4 graded (0 with full marks), 1 ungradable" in said
    assert "2 judged in" in said
    assert "3 kept from an earlier run" in said
    assert "[2/2]" in progress
    for one in results:
        if one.status == "graded":
            assert json.loads((out / str(one.recording)).read_text())["format"] == 1
    rows = (out / "grades.csv").read_text("utf-8-sig").splitlines()
    assert [row.split(",")[0] for row in rows] == ["student", "s1", "s2", "s3", "s4", "s5"]


def test_a_slot_that_is_killed_is_replaced_and_the_answer_is_judged(tmp_path: Path) -> None:
    marks = tmp_path / "marks"
    jobs = [Job("slow", STEM, Answer(once(marks, "time.sleep(600)"))), Job("next", STEM, Answer(UNREADABLE))]
    found: dict[str, Judgement] = {}

    def work() -> None:
        for job, judgement in judge_all(jobs, 1):
            found[job.key] = judgement

    judging = threading.Thread(target=work)
    judging.start()
    pids = pids_in(marks)
    os.kill(pids[0], signal.SIGKILL)
    judging.join()
    assert {key: judgement.status for key, judgement in found.items()} == {"slow": "graded", "next": "graded"}
    recording = found["slow"].recording
    assert recording is not None
    assert recording.process.exit == 3
    wait_until(lambda: all(map(is_gone, pids)))


def test_an_answer_that_kills_its_judge_twice_is_no_zero_and_stops_nobody(tmp_path: Path) -> None:
    killer = f"{CLIMB}os.kill(judge(), signal.SIGKILL)\n"
    jobs = [Job("killer", STEM, Answer(killer)), Job("next", STEM, Answer(UNREADABLE))]
    found = {job.key: judgement for job, judgement in judge_all(jobs, 1)}
    assert (found["killer"].status, found["killer"].score) == ("ungradable", None)
    assert found["next"].status == "graded"


def test_a_slot_ends_with_everything_that_its_answer_started(tmp_path: Path) -> None:
    marks = tmp_path / "marks"
    slot = Slot()
    errors: list[BaseException] = []

    def work() -> None:
        try:
            slot.judge(STEM, Answer(once(marks, "time.sleep(600)")), soak=False)
        except Exception as error:
            errors.append(error)

    judging = threading.Thread(target=work)
    judging.start()
    pids = pids_in(marks)
    slot.kill()
    judging.join()
    slot.close()
    assert "the slot ended" in str(errors[0])
    wait_until(lambda: all(map(is_gone, pids)))


def test_a_daemon_does_not_outlive_the_judgement(tmp_path: Path) -> None:
    marks = tmp_path / "marks"
    with Slot() as slot:
        first = slot.judge(STEM, Answer(once(marks, "raise SystemExit(4)")), soak=False)
        pids = pids_in(marks)
        assert first.status == "graded"
        wait_until(lambda: all(map(is_gone, pids[1:])))
        assert not is_gone(pids[0]), "the slot is ready for the next answer"
    wait_until(lambda: is_gone(pids[0]))


def test_a_job_that_cannot_be_judged_is_said_and_the_slot_lives_on() -> None:
    with Slot() as slot:
        unknown = slot.judge("77_levitation", Answer("x = 1\n"), soak=False)
        assert unknown.status == "infra_error"
        assert "77_levitation" in (unknown.reason or "")
        assert slot.is_running


# --- the command line -----------------------------------------------------------------------------------------------


def outcome(*arguments: object) -> tuple[int, str, str]:
    with workbook(*arguments) as process:
        said, errors = process.communicate()
    return process.returncode, said, errors


def test_check_says_full_marks_with_exit_code_0() -> None:
    code, said, errors = outcome("check", "joint_positions", ROOT / "solutions" / f"{STEM}.py")
    assert code == 0, said + errors
    assert "Full marks: 10 of 10 points." in said
    named = said.split("Hand in this file: ")[1].split("\n")[0]
    assert (Path.cwd() / named).resolve() == ROOT / "solutions" / f"{STEM}.py"


def test_check_says_not_yet_with_exit_code_1(tmp_path: Path) -> None:
    (tmp_path / "answer.py").write_text(UNREADABLE)
    code, said, errors = outcome("check", STEM, tmp_path / "answer.py")
    assert code == 1, said + errors
    assert "0 of 10 points." in said
    assert "SyntaxError" in said
    assert "\x1b" not in said


def test_check_tries_once_more_what_crashes_at_ctrl_c(tmp_path: Path) -> None:
    """As an occasional bug in rclpy does: see `workbook.exercise.inconclusive`."""
    stem, was_here = "08_humanoid_status_publisher", tmp_path / "was here"
    solution = load_exercise(stem, ROOT).source.solution_code
    shutdown = "    finally:\n        rclpy.try_shutdown()"
    assert shutdown in solution
    crash = (
        f"        import os, signal\n        if not os.path.exists({str(was_here)!r}):\n"
        f"            open({str(was_here)!r}, 'x').close()\n            os.kill(os.getpid(), signal.SIGSEGV)"
    )
    (tmp_path / "answer.py").write_text(
        solution.replace(shutdown, shutdown.replace("\n", "\n" + crash + "\n"))
    )
    code, said, errors = outcome("check", stem, tmp_path / "answer.py")
    assert was_here.exists(), said + errors
    assert code == 0, said + errors
    assert "Full marks: 10 of 10 points." in said
    assert "Your program is judged once more" in errors


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("check", STEM, "/no/such/answer.py"), "there is no file"),
        (("check", "levitation"), "levitation"),
        (("grade", "/no/such/folder", "--exercise", STEM, "--out", "{out}"), "/no/such/folder"),
        (("grade", ".", "--exercise", "levitation", "--out", "{out}"), "levitation"),
        (("grade", ".", "--exercise", STEM, "--out", "{out}", "--slots", "0"), "--slots must be at least 1"),
        (("grade", "{empty}", "--out", "{out}"), "Name it with --exercise"),
    ],
    ids=["no file", "no exercise", "no folder", "no such exercise", "no slots", "not inferred"],
)
def test_what_cannot_be_judged_ends_with_exit_code_2(
    arguments: tuple[str, ...],
    words: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    from workbook.cli.main import main

    monkeypatch.chdir(tmp_path)
    (tmp_path / "empty").mkdir()
    places = {"out": tmp_path / "out", "empty": tmp_path / "empty"}
    assert main([argument.format(**places) for argument in arguments]) == 2
    said = capsys.readouterr()
    assert words in said.err
    assert "Traceback" not in said.err
    assert not said.out


def test_grade_ends_with_exit_code_1_when_something_was_our_fault(
    tmp_path: Path, judges: ScriptedBackend, capsys: pytest.CaptureFixture[str]
) -> None:
    from workbook.cli.main import main

    answer = tmp_path / "joint_positions_s1042.py"
    answer.write_text("robot = 1\n")
    judges.ours_to_blame = {answer.stem}
    assert main(["grade", str(answer), "--out", str(tmp_path / "out")]) == 1
    said = capsys.readouterr()
    assert "1 not judged because of an error in the judge" in said.out
    assert "the slot is gone" in said.out
    judges.ours_to_blame.clear()
    assert main(["grade", str(answer), "--out", str(tmp_path / "out")]) == 0


def test_types_are_learned_once_before_slots_start_that_cannot_write(monkeypatch: pytest.MonkeyPatch) -> None:
    done: list[str] = []

    def judged(
        pool: object, slot: object, kind: object, job: Job[str], **_: object
    ) -> tuple[None, Judgement]:
        done.append("judged")
        return None, Judgement(job.stem, job.answer.sha256, "infra_error", "nobody judges here", (), None)

    monkeypatch.setattr(scheduler, "warm_cache", lambda: done.append("warmed"))
    monkeypatch.setattr(pool, "judge_with_retry", judged)
    answer = Answer("")
    list(judge_all([Job("a", "09_joint_positions", answer)], 1))
    assert done == ["judged"]
    list(judge_all([Job("a", "07_typed_nodes", answer), Job("b", "07_typed_nodes", answer)], 1))
    assert done == ["judged", "warmed", "judged", "judged"]


@pytest.mark.parametrize("place", [".", "graded", "deep/graded", ".."])
def test_results_among_the_answers_are_no_hand_ins(
    place: str, exercise: Exercise, hand_ins: Path, judges: ScriptedBackend
) -> None:
    out = hand_ins / place
    for _ in range(2):
        out.mkdir(parents=True, exist_ok=True)
        summary = Batch(exercise, out, LocalSlots(2)).run([hand_ins])
        for name in ("recordings", "pages", "gradescope"):
            (out / name).mkdir(exist_ok=True)
        names = {result.student for result in summary.results} - {"deep"}
        assert names == {"s0", "s1", "s2", "s3", "s4"}
    other = Batch(exercise, hand_ins.parent / "other", LocalSlots(2)).run([hand_ins])
    if place == "graded":
        assert len(other.results) == 5


def test_a_result_without_a_hand_in_is_named_and_left_out(
    exercise: Exercise, hand_ins: Path, judges: ScriptedBackend, tmp_path: Path
) -> None:
    out = hand_ins.parent / "out"

    def listed() -> set[str]:
        with (out / "grades.csv").open(encoding="utf-8-sig", newline="") as file:
            return {row["student"] for row in csv.DictReader(file)}

    assert not grade(exercise, hand_ins).remarks
    (hand_ins / "s2.py").rename(hand_ins / "s9.py")
    (remark,) = grade(exercise, hand_ins).remarks
    assert remark.startswith("1 earlier result has no hand-in in this run: s2. Exports leave them out")
    assert listed() == {"s0", "s1", "s3", "s4", "s9"}
    late = tmp_path / "s7.py"
    late.write_text("raise SystemExit\n")
    assert not Batch(exercise, out, LocalSlots(2)).run([late]).remarks
    assert listed() == {"s0", "s1", "s3", "s4", "s7", "s9"}
