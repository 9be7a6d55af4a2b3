"""A real scheduler and real workers on loopback: lost answers are judged elsewhere, and a bad answer harms no other."""

import asyncio
import gc
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import threading
from collections import Counter
from collections.abc import Iterator
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import pytest

from tests.grading.farms import ROOT, LittleFarm, ancestors_of, little_farm
from tests.programs.support import CLIMB, wait_until
from workbook.authoring.tree import Tree
from workbook.authoring.wrong_answers import read_wrong_answer
from workbook.exercise.answers import Answer
from workbook.exercise.course import course_sha256
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement, judge_recording
from workbook.exercise.serialization import judgement_from_afar, judgement_to_json
from workbook.grading import farm_worker
from workbook.grading.farm_worker import FarmJob
from workbook.grading.slots import pool as slot_pool
from workbook.grading.slots.client import slot_environment
from workbook.grading.slots.pool import Kind, SlotPool
from workbook.isolation.bubblewrap import sandbox_problem
from workbook.recording.recording import Recording

STEM = "09_joint_positions"
UNREADABLE = "speed = = 3\n"
POISON = (
    CLIMB
    + """
for pid, command in line_of_ancestors():
    if b"multiprocessing" in command or b"/dask" in command:
        os.kill(pid, signal.SIGKILL)
        break
raise SystemExit(3)
"""
)


@pytest.fixture(scope="module")
def scheduler(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LittleFarm]:
    pytest.importorskip("distributed", reason="the extra `farm` is not installed")
    with little_farm(tmp_path_factory.mktemp("shared") / "farm") as farm:
        yield farm


@pytest.fixture
def farm(scheduler: LittleFarm) -> Iterator[LittleFarm]:
    """Start a farm without workers. Workers that a test starts end with the test."""
    yield scheduler
    scheduler.end_workers()


@pytest.fixture
def own_farm(tmp_path: Path) -> Iterator[LittleFarm]:
    """Start a farm whose scheduler the test may kill."""
    pytest.importorskip("distributed", reason="the extra `farm` is not installed")
    with little_farm(tmp_path / "farm") as farm:
        yield farm


def slow_once(marks: Path) -> str:
    """Return an answer that says that it runs, and waits. Run again, it ends right away."""
    return f"""\
import os, time
marks = {str(marks)!r}
if os.path.exists(marks):
    raise SystemExit(3)
with open(marks + ".part", "w") as file:
    file.write(str(os.getpid()))
os.rename(marks + ".part", marks)
time.sleep(600)
"""


def results(out: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in (out / "results.jsonl").read_text().splitlines()]


def lost(result: dict[str, Any]) -> set[str]:
    return {one["id"] for one in result["criteria"] if one["status"] in ("failed", "partial")}


def finish(process: "subprocess.Popen[str]") -> tuple[int, str]:
    with process:
        said, errors = process.communicate()
    assert "Traceback" not in said + errors, errors
    return process.returncode, said + errors


# --- the farm --------------------------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.whole
def test_a_killed_worker_loses_nothing(farm: LittleFarm, tmp_path: Path) -> None:
    folder, out, marks = tmp_path / "class", tmp_path / "out", tmp_path / "marks"
    folder.mkdir()
    solution = load_exercise(STEM, ROOT).source.solution_code
    wrong = (
        "eleven_values",
        "wrong_name",
        "battery_renamed",
        "battery_above_hundred",
        "attribute_name_taken",
    )
    expected: dict[str, set[str]] = {"slow": {"program_runs"}}
    (folder / "slow.py").write_text(slow_once(marks))
    for number in range(3):
        (folder / f"right{number}.py").write_text(f"{solution}\n# {number}\n")
        expected[f"right{number}"] = set()
        (folder / f"unreadable{number}.py").write_text(f"{UNREADABLE}# {number}\n")
        expected[f"unreadable{number}"] = {"program_runs"}
    for name in wrong:
        mistaken = read_wrong_answer(Tree(ROOT), Tree(ROOT).wrong_answers / STEM / f"{name}.py")
        (folder / f"{name}.py").write_text(mistaken.answer.text)
        expected[name] = set(mistaken.header.loses)
    workers = {worker.pid: worker for worker in (farm.worker(), farm.worker())}

    grader = farm.grade(folder, "--out", out, "--isolation", "limits")
    try:
        wait_until(marks.exists)
        farm.processes()
        [holder] = [pid for pid in ancestors_of(int(marks.read_text())) if pid in workers]
        os.kill(holder, signal.SIGKILL)
        workers[holder].wait()
    except BaseException:
        grader.kill()
        raise
    code, said = finish(grader)

    assert code == 0, said
    assert "6 slots of 2 workers" in said
    assert re.search(r"is gone\. Its .*answers? (is|are) judged again elsewhere", said), said
    found = results(out)
    assert Counter(one["student"] for one in found) == dict.fromkeys(expected, 1)
    assert {one["student"]: lost(one) for one in found} == expected
    assert {one["status"] for one in found} == {"graded"}
    assert {one["isolation"] for one in found} == {"limits"}
    for one in found:
        assert json.loads((out / one["recording"]).read_text())["format"] == 1
    assert {one["process"]["exit"] for one in found if one["student"] == "slow"} == {3}


@pytest.mark.slow
@pytest.mark.whole
def test_a_poison_answer_takes_no_neighbor_with_it(farm: LittleFarm, tmp_path: Path) -> None:
    folder, out = tmp_path / "class", tmp_path / "out"
    folder.mkdir()
    (folder / "poison.py").write_text(POISON)
    for number in range(5):
        (folder / f"s{number}.py").write_text(f"{UNREADABLE}# {number}\n")
    farm.worker(nanny=True)

    code, said = finish(farm.grade(folder, "--out", out, "--isolation", "limits"))
    farm.processes()

    assert code == 1, said
    found = {one["student"]: one for one in results(out)}
    assert len(results(out)) == len(found) == 6
    assert {one["status"] for name, one in found.items() if name != "poison"} == {"graded"}
    assert (found["poison"]["status"], found["poison"]["score"]) == ("infra_error", None)
    assert "3 tries, two of them with a worker to itself" in found["poison"]["reason"]
    assert "1 not judged because of an error in the judge" in said


@pytest.mark.slow
@pytest.mark.whole
def test_ctrl_c_ends_in_order_and_a_second_run_goes_on(farm: LittleFarm, tmp_path: Path) -> None:
    folder, out, marks = tmp_path / "class", tmp_path / "out", tmp_path / "marks"
    folder.mkdir()
    (folder / "a.py").write_text(slow_once(marks).replace("600", "4"))
    for number in range(8):
        (folder / f"s{number}.py").write_text(f"{UNREADABLE}# {number}\n")
    farm.worker("--nthreads", 1)
    command = (folder, "--out", out, "--isolation", "limits")

    grader = farm.grade(*command)
    wait_until(lambda: marks.exists() or grader.poll() is not None)
    grader.send_signal(signal.SIGINT)
    code, said = finish(grader)
    assert code == 130, said
    assert "Stopping once the current answers are judged" in said
    first = results(out)
    assert [one["student"] for one in first] == ["a"]

    code, said = finish(farm.grade(*command))
    assert code == 0, said
    assert "8 judged in" in said
    assert "1 kept from an earlier run" in said
    assert results(out)[:1] == first
    assert Counter(one["student"] for one in results(out)) == {"a": 1, **{f"s{n}": 1 for n in range(8)}}
    farm.processes()


@pytest.mark.slow
@pytest.mark.whole
def test_a_scheduler_that_goes_away_is_told_and_nothing_is_lost(own_farm: LittleFarm, tmp_path: Path) -> None:
    folder, out, marks = tmp_path / "class", tmp_path / "out", tmp_path / "marks"
    folder.mkdir()
    (folder / "a.py").write_text(f"{UNREADABLE}\n")
    (folder / "b.py").write_text(slow_once(marks))
    own_farm.worker("--nthreads", 1)
    grader = own_farm.grade(folder, "--out", out, "--isolation", "limits")
    wait_until(lambda: marks.exists() or grader.poll() is not None)
    own_farm.processes()
    own_farm.scheduler.kill()
    code, said = finish(grader)
    assert code == 2, said
    assert "does not answer any more" in said
    assert "run the same command" in said
    assert [one["student"] for one in results(out)] == ["a"]


@pytest.mark.sandbox
@pytest.mark.slow
@pytest.mark.whole
def test_the_best_tier_and_own_criteria(farm: LittleFarm, tmp_path: Path) -> None:
    problem = sandbox_problem()
    if problem is not None:
        pytest.skip(f"programs cannot be sandboxed: {problem}")
    folder, out, own = tmp_path / "class", tmp_path / "out", tmp_path / "own"
    folder.mkdir()
    own.mkdir()
    (folder / "s1.py").write_text(f"{POISON}")
    (own / f"{STEM}.py").write_text(
        "import workbook.criteria as see\n"
        "from workbook.criteria import Recording, Verdict, criterion\n\n\n"
        "@criterion(points=2, title='It talks')\n"
        "def talks(recording: Recording) -> Verdict:\n"
        "    return see.failed('own.nothing', 'nothing', 'a word', 'It is silent.', 'Say something.')\n"
    )
    farm.worker("--nthreads", 1)
    code, said = finish(farm.grade(folder, "--out", out, "--criteria", own))
    assert code == 0, said
    assert "Isolation: sandbox." in said
    [result] = results(out)
    assert (result["status"], result["isolation"], result["score"]) == ("graded", "sandbox", 0)
    assert [(one["id"], one["hidden"]) for one in result["criteria"]][-1] == ("talks", True)
    farm.processes()


@pytest.mark.slow
@pytest.mark.whole
def test_workers_that_cannot_judge_as_asked_refuse_with_words(farm: LittleFarm, tmp_path: Path) -> None:
    other, programs, stranger = tmp_path / "other", tmp_path / "programs", tmp_path / "stranger"
    for name in ("exercises/criteria", "exercises/drivers", "solutions"):
        shutil.copytree(ROOT / name, other / name)
    with (other / "exercises" / "criteria" / f"{STEM}.py").open("a") as file:
        file.write("# not what it was\n")
    programs.mkdir()
    (stranger / "workbook").mkdir(parents=True)
    (stranger / "workbook" / "__init__.py").touch()
    (tmp_path / "s1.py").write_text(UNREADABLE)
    farm.worker(WORKBOOK_COURSE=str(other))
    farm.worker(PATH=str(programs))
    farm.worker(PYTHONPATH=str(stranger))

    code, said = finish(farm.grade(tmp_path / "s1.py", "--out", tmp_path / "out"))
    assert code == 2, said
    assert "no worker at tcp://127.0.0.1:" in said
    assert "it has another version of the course in" in said
    assert "it cannot confine programs: bubblewrap is not installed" in said
    assert "it ended before it answered our first request. Start it in the course's folder" in said
    assert not (tmp_path / "out").exists()

    code, said = finish(farm.grade(tmp_path / "s1.py", "--out", tmp_path / "out", "--isolation", "limits"))
    assert code == 0, said
    assert "3 slots of 1 worker at" in said
    farm.processes()


def test_a_scheduler_without_workers(farm: LittleFarm, tmp_path: Path) -> None:
    (tmp_path / "s1.py").write_text(UNREADABLE)
    code, said = finish(farm.grade(tmp_path / "s1.py", "--out", tmp_path / "out"))
    assert code == 2
    assert "has no workers" in said
    assert f".venv/bin/dask worker {farm.address} --nthreads" in said


def test_waits_that_nobody_receives_are_not_told_to_the_instructor(caplog: pytest.LogCaptureFixture) -> None:
    AllExit = pytest.importorskip("distributed.client", reason="the extra `farm` is not installed").AllExit

    from workbook.grading.farm_connection import quiet_about_lost_waits

    async def end_with(error: BaseException) -> None:
        raise error

    async def leave_behind(*errors: BaseException) -> None:
        asyncio.get_running_loop().set_exception_handler(quiet_about_lost_waits)
        for error in errors:
            await asyncio.wait([asyncio.ensure_future(end_with(error))])
        gc.collect()

    asyncio.run(leave_behind(AllExit()))
    assert not caplog.records
    asyncio.run(leave_behind(AllExit(), ValueError("a fault of ours")))
    said = caplog.text
    assert "a fault of ours" in said
    assert "AllExit" not in said


# --- without a farm --------------------------------------------------------------------------------------------------


def grade(tmp_path: Path, *arguments: str) -> int:
    from workbook.cli.main import main

    (tmp_path / "s1.py").write_text(UNREADABLE)
    out = str(tmp_path / "out")
    return main(["grade", str(tmp_path / "s1.py"), "--exercise", STEM, "--out", out, *arguments])


def test_nobody_at_the_address(tmp_path: Path) -> None:
    pytest.importorskip("distributed", reason="the extra `farm` is not installed")
    with socket.socket() as closed:  # bound, but not listening
        closed.bind(("127.0.0.1", 0))
        address = f"tcp://127.0.0.1:{closed.getsockname()[1]}"
        code = (
            "import sys; from workbook.grading import farm_connection; farm_connection.CONNECT_S = 1.0; "
            "from workbook.cli.main import main; sys.exit(main(sys.argv[1:]))"
        )
        (tmp_path / "s1.py").write_text(UNREADABLE)
        done = subprocess.run(
            [
                *(sys.executable, "-c", code, "grade", tmp_path / "s1.py", "--exercise", STEM),
                *("--out", tmp_path / "out", "--farm", address),
            ],
            capture_output=True,
            text=True,
        )
    assert done.returncode == 2
    assert f"no scheduler answers at {address}" in done.stderr
    assert "Start one" in done.stderr
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "out").exists()


def test_without_the_extra(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    assert grade(tmp_path, "--farm", "tcp://127.0.0.1:8786") == 2
    said = capsys.readouterr().err
    assert "make env EXTRAS=farm" in said
    assert "Traceback" not in said


def test_encryption_without_certificates(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("distributed", reason="the extra `farm` is not installed")
    assert grade(tmp_path, "--farm", "tls://127.0.0.1:8786") == 2
    assert "needs certificates: see 'A farm' in exercises/README.md" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--farm", "lab-01:8786"), "write it as tcp://host:8786"),
        (("--farm", "tcp://lab-01"), "write it as tcp://host:8786"),
        (("--farm", "inproc://1/2"), "write it as tcp://host:8786"),
        (("--farm", "tcp://lab-01:8786", "--slots", "4"), "dask worker --nthreads"),
    ],
)
def test_what_is_no_farm_is_said(
    arguments: tuple[str, ...], words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert grade(tmp_path, *arguments) == 2
    assert words in capsys.readouterr().err


# --- a worker's replies ----------------------------------------------------------------------------------------------


def order(**changes: object) -> str:
    usual = FarmJob(STEM, UNREADABLE, False, "limits", course_sha256(), None, farm_worker.PROCESS)
    return replace(usual, **changes).to_text()  # type: ignore[arg-type]


def test_an_order_for_another_process_is_not_followed() -> None:
    assert json.loads(farm_worker.judge(order(process="another"))) == {"elsewhere": True}


def test_an_order_for_another_version_of_the_course_is_refused() -> None:
    [(key, words)] = json.loads(farm_worker.judge(order(course="0" * 64))).items()
    assert key == "refused"
    assert "another version of the course" in words


def test_a_course_that_changed_under_a_worker_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(farm_worker, "_COURSE_LOADED", "0" * 64)
    assert "has changed since this worker was started" in json.loads(farm_worker.judge(order()))["refused"]


def test_whatever_goes_wrong_comes_back_as_words() -> None:
    assert json.loads(farm_worker.judge("{}"))["fault"] == "Malformed: exercise: it is missing"
    assert "fault" in json.loads(farm_worker.judge("no order"))


def test_the_version_of_a_course_is_in_each_file_that_judges(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("exercises/criteria", "solutions"):
        shutil.copytree(ROOT / name, tmp_path / name, ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setenv("WORKBOOK_COURSE", str(tmp_path))
    before = course_sha256()
    assert before == course_sha256()
    for name in ("criteria/more.py", "criteria/more.toml", "drivers/more.py", "../solutions/more.py"):
        file = tmp_path / "exercises" / name
        file.parent.mkdir(exist_ok=True)
        file.write_text("x = 1\n")
        assert course_sha256() != before
        file.unlink()
    assert course_sha256() == before


class _Slot:
    is_running = True

    def __init__(self) -> None:
        self.closed = threading.Event()
        self.environ = slot_environment(None)

    def close(self) -> None:
        self.closed.set()


def test_a_slot_waits_for_the_next_answer_of_its_kind_and_not_for_ever() -> None:
    pool = SlotPool(idle_s=0.2)
    slot: Any = _Slot()
    kind = Kind("limits", None)
    pool.give(kind, slot)
    assert pool.take_warm(Kind("sandbox", None)) is None
    assert pool.take_warm(kind) is slot
    assert pool.take_warm(kind) is None
    assert not slot.closed.is_set()
    pool.give(kind, slot)
    assert slot.closed.wait(30.0)
    assert pool.take_warm(kind) is None


class _Server(_Slot):
    """The process from which slots are forked."""


def test_with_the_last_slot_of_a_kind_goes_what_it_was_forked_from(monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[_Server] = []

    def start(*_: object) -> _Server:
        made.append(_Server())
        return made[-1]

    monkeypatch.setattr(slot_pool, "slot_server", start)
    pool = SlotPool(idle_s=0.2)
    slots: list[Any] = [_Slot(), _Slot()]
    kind, other = Kind("limits"), Kind("sandbox")
    for one in (kind, kind, other):
        pool.fork_from_now_on(one)
    of_kind, of_other = made
    monkeypatch.setattr(slot_pool, "Slot", lambda *_, **__: slots[0])
    assert pool.take(other) is slots[0]
    pool.give(kind, slots[1])
    assert of_kind.closed.wait(30.0) and slots[1].closed.is_set()
    assert not of_other.closed.is_set(), "one of its slots is at work"
    pool.fork_from_now_on(kind)
    assert len(made) == 3
    pool.give(other, slots[0])
    assert of_other.closed.wait(30.0)


# --- what the scheduler accepts from a reply --------------------------------------------------------------------------


@pytest.fixture
def judgement() -> Judgement:
    recording = Recording.load(ROOT / "tests" / "recordings" / STEM / "eleven_values.json")
    return judge_recording(load_exercise(STEM, ROOT), Answer(UNREADABLE).sha256, recording)


def from_afar(data: object) -> Judgement:
    return judgement_from_afar(data, STEM, Answer(UNREADABLE).sha256)


def test_a_judgement_survives_the_journey(judgement: Judgement) -> None:
    arrived = from_afar(json.loads(json.dumps(judgement_to_json(judgement))))
    assert asdict(arrived) == asdict(judgement)


def _set(*path: str | int, to: object) -> Any:
    def change(data: Any) -> object:
        for step in path[:-1]:
            data = data[step]
        data[path[-1]] = to
        return None

    return change


@pytest.mark.parametrize(
    "change",
    [
        _set("stem", to="05_timers"),
        _set("answer_sha256", to="0" * 64),
        _set("status", to="passed"),
        _set("provisional", to=True),
        _set("reason", to=["a", "list"]),
        _set("reason", to="half a character: \ud83d"),
        _set("criteria", to=[]),
        _set("criteria", to={}),
        _set("criteria", 0, "points", to=1e9),
        _set("criteria", 0, "points", to=-1),
        _set("criteria", 0, "points", to=float("nan")),
        _set("criteria", 0, "points", to="10"),
        _set("criteria", 0, "hidden", to="no"),
        _set("criteria", 0, "status", to="skipped, honestly"),
        _set("criteria", 0, "saw", to=None),
        _set("criteria", 0, "more", to=1),
        _set("recording", to=None),
        _set("recording", "format", to=2),
        _set("recording", "clock", to="sundial"),
        _set("recording", "wall_s", to=None),
        _set("recording", "topics", to=[]),
        _set("recording", "nodes", to=[{"name": 1, "first_seen": 0.0}]),
        _set("recording", "process", "limits_hit", to=[1]),
        _set("recording", "process", "log", to={"__reduce__": "os.system"}),
    ],
)
def test_a_damaged_judgement_is_not_taken(judgement: Judgement, change: Any) -> None:
    data = json.loads(json.dumps(judgement_to_json(judgement)))
    change(data)
    with pytest.raises(ValueError, match=r"\w"):
        from_afar(data)


@pytest.mark.parametrize("data", [None, [], "graded", 7, {}])
def test_what_is_no_judgement_is_not_taken(data: object) -> None:
    with pytest.raises(ValueError, match="not a judgment"):
        from_afar(data)
