"""Forked slots isolate as fresh ones do, programs can't tell the difference, and no process is left behind."""

import json
import os
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.programs.support import is_gone, wait_until
from tests.programs.test_fork_client import OF_ITSELF
from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement
from workbook.grading.judges import Job
from workbook.grading.slots import pool
from workbook.grading.slots.client import ForkedSlot, Slot, SlotServer
from workbook.grading.slots.forking import SlotForker, SlotRequest
from workbook.grading.slots.pool import Kind, SlotPool, judge_with_retry, slot_server
from workbook.grading.slots.scheduler import judge_all
from workbook.inside import fork_server
from workbook.inside.lttng import LttngForkHooks
from workbook.inside.proc import children, command_line, environment, process_tree
from workbook.isolation.bubblewrap import sandbox_problem
from workbook.isolation.memory_groups import groups_problem
from workbook.isolation.tiers import Isolation
from workbook.programs.fork_client import NotForked, started_program

STEM = "09_joint_positions"
HOG = """
import time

held = []
while True:
    held.append(bytearray(50_000_000))
    time.sleep(0.001)
"""
SPACES = ("user", "net", "ipc", "mnt")
pytestmark = pytest.mark.slow
in_sandbox = pytest.mark.skipif(sandbox_problem() is not None, reason=f"no sandbox: {sandbox_problem()}")


@pytest.fixture(scope="module")
def server() -> Iterator[SlotServer]:
    made = slot_server("sandbox")
    assert made is not None
    yield made
    made.close()


def judged(slot: Slot, text: str) -> Judgement:
    return slot.judge(STEM, Answer(text), soak=False)


def right_answer() -> str:
    return load_exercise(STEM).source.solution_code


def is_forked(slot: Slot) -> bool:
    return isinstance(slot._process, ForkedSlot)


def spaces(pid: int) -> dict[str, str]:
    return {name: os.readlink(f"/proc/{pid}/ns/{name}") for name in SPACES}


def rights(pid: int) -> list[str]:
    lines = Path(f"/proc/{pid}/status").read_text().splitlines()
    return [
        line
        for line in lines
        if line.startswith(("Cap", "NoNewPrivs", "Uid", "Gid", "Seccomp:", "SigBlk", "SigIgn", "SigCgt"))
    ]


def judge_pid(slot: Slot) -> int:
    pid = slot._health._judge()
    assert pid is not None
    return pid


@pytest.mark.parametrize("tier", [pytest.param("sandbox", marks=in_sandbox), "limits"])
def test_a_forked_slot_judges_as_a_fresh_one_does(tier: Isolation) -> None:
    server = slot_server(tier)
    assert server is not None
    with Slot(tier, server=server) as slot:
        assert is_forked(slot)
        pid = judge_pid(slot)
        assert judged(slot, right_answer()).full_marks
        assert judged(slot, right_answer()).full_marks, "and again"
        assert not judged(slot, "robot = 1\n").full_marks
        assert slot.is_running
    assert is_gone(pid)
    server.close()


@in_sandbox
def test_each_has_name_spaces_of_its_own_and_the_rights_of_a_fresh_one(server: SlotServer) -> None:
    with (
        Slot("sandbox", server=server) as one,
        Slot("sandbox", server=server) as other,
        Slot("sandbox") as fresh,
    ):
        for slot in (one, other, fresh):
            judged(slot, "robot = 1\n")
        assert (is_forked(one), is_forked(other), is_forked(fresh)) == (True, True, False)
        parent = int(Path(f"/proc/{judge_pid(one)}/stat").read_text().rpartition(")")[2].split()[1])
        found = [spaces(pid) for pid in (os.getpid(), parent, *map(judge_pid, (one, other, fresh)))]
        for name in SPACES:
            assert len({each[name] for each in found}) == len(found), name
        assert rights(judge_pid(one)) == rights(judge_pid(fresh))
        told = [
            dict(line.split(b"=", 1) for line in environment(judge_pid(slot)) if line)
            for slot in (one, fresh)
        ]
        assert told[0] == told[1]
        assert os.readlink(f"/proc/{judge_pid(one)}/cwd") == os.readlink(f"/proc/{judge_pid(fresh)}/cwd")


@in_sandbox
def test_a_program_cannot_tell_that_its_slot_was_forked(server: SlotServer) -> None:
    found: list[dict[str, Any]] = []
    for source in (server, None):
        with Slot("sandbox", server=source) as slot:
            judged(slot, right_answer())
            recording = judged(slot, OF_ITSELF).recording
            assert recording is not None
            told = json.loads(recording.process.log)
            del told["environment"]["ROS_DOMAIN_ID"]
            found.append(told)
    assert found[0] == found[1]
    assert found[0]["others"] == []


@in_sandbox
def test_the_kernel_counts_the_memory_of_its_programs(server: SlotServer) -> None:
    with Slot("sandbox", server=server) as slot:
        assert (slot._groups is None) == (groups_problem() is not None)
        recording = judged(slot, HOG).recording
        assert recording is not None and recording.process.limits_hit == ("memory",)
        assert judged(slot, right_answer()).full_marks


@in_sandbox
def test_a_killed_slot_takes_its_program_and_its_sandbox_along(server: SlotServer) -> None:
    with Slot("sandbox", server=server) as other:
        judged(other, "robot = 1\n")
        before = set(process_tree(server.pid))
        slot = Slot("sandbox", server=server)
        judged(slot, "robot = 1\n")
        mine = set(process_tree(server.pid)) - before
        assert judge_pid(slot) in mine and len(mine) > 2
        slot.kill()
        slot.close()
        wait_until(lambda: all(map(is_gone, mine)), "all of the slot go")
        assert judged(other, right_answer()).full_marks, "the others go on"


@in_sandbox
def test_where_forked_ones_do_not_isolate_fresh_ones_are_started(monkeypatch: pytest.MonkeyPatch) -> None:
    forked: list[ForkedSlot] = []

    def tried(self: SlotServer, groups: Any) -> tuple[ForkedSlot, str]:
        forked.append(self._fork(groups))
        return forked[0], "a program reads a file of the judge"

    monkeypatch.setattr(SlotServer, "_tried", tried)
    server = slot_server("sandbox")
    assert server is not None
    with Slot("sandbox", server=server) as slot:
        assert not is_forked(slot)
        wait_until(lambda: is_gone(forked[0].pid))
        assert judged(slot, right_answer()).full_marks
    with pytest.raises(NotForked, match="reads a file of the judge"):
        server.fork(None)
    assert len(forked) == 1, "it is tried once"
    server.close()


@in_sandbox
def test_without_its_server_a_slot_is_started_afresh() -> None:
    server = slot_server("sandbox")
    assert server is not None
    slot = Slot("sandbox", server=server)
    judged(slot, "robot = 1\n")
    pid = judge_pid(slot)
    os.kill(server.pid, signal.SIGKILL)
    wait_until(lambda: is_gone(pid))
    slot.kill()
    slot.close()
    with Slot("sandbox", server=server) as after:
        assert not is_forked(after)
        assert judged(after, right_answer()).full_marks
    server.close()


@in_sandbox
@pytest.mark.whole
def test_an_answer_whose_server_is_killed_is_judged_again(server: SlotServer) -> None:
    """The first slot is gone then. The second one forks its programs from a separate server."""
    slot = Slot("sandbox", server=server)
    judged(slot, "robot = 1\n")
    for zygote in zygotes_of(server):
        threading.Timer(1.0, os.kill, (zygote, signal.SIGKILL)).start()
    job = Job("one", STEM, Answer(right_answer()))
    slot_after, judgement = judge_with_retry(SlotPool(), slot, Kind("sandbox"), job, soak=True)
    assert judgement.full_marks, judgement.reason
    assert slot_after is not None and slot_after is not slot
    slot_after.close()
    with Slot("sandbox", server=server) as third:
        assert is_forked(third)
        assert judged(third, right_answer()).full_marks


def zygotes_of(server: SlotServer) -> list[int]:
    """Return the fork servers that the slot server started. Those that belong to slots are their children."""
    found = [pid for pid in process_tree(server.pid) if b"fork_server" in command_line(pid)]
    return [pid for pid in found if not any(pid in children(other) for other in found)]


def test_how_a_slot_ended_is_not_taken_for_its_number() -> None:
    reading, writing = os.pipe()
    os.write(writing, b"\n9\n")
    os.close(writing)
    with pytest.raises(NotForked, match="the process that forks does not answer"):
        started_program(reading, 1.0)
    reading, writing = os.pipe()
    os.write(writing, b"4321\n\n9\n")
    os.close(writing)
    program = started_program(reading, 1.0)
    assert (program.pid, program.wait(), program.is_lost) == (4321, -signal.SIGKILL, False)
    program.close()


@pytest.fixture
def no_forks(monkeypatch: pytest.MonkeyPatch) -> None:
    def fork() -> int:
        raise BlockingIOError(11, "Resource temporarily unavailable")

    monkeypatch.setattr(os, "fork", fork)


@pytest.mark.usefixtures("no_forks")
def test_a_slot_server_that_cannot_fork_says_so_and_goes_on() -> None:
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    signals = signal.pthread_sigmask(signal.SIG_BLOCK, ())
    forker = SlotForker("limits", theirs, (), -1)
    for _ in range(2):
        reading, writing = os.pipe()
        pipes = [os.dup(writing) for _ in range(3)]
        os.close(writing)
        assert forker._fork(SlotRequest(None, "/", None), pipes) is False
        with pytest.raises(NotForked, match="Resource temporarily unavailable"):
            started_program(reading, 1.0)
    assert signal.pthread_sigmask(signal.SIG_BLOCK, ()) == signals
    ours.close()
    theirs.close()


@pytest.mark.usefixtures("no_forks")
def test_a_fork_server_that_cannot_fork_says_so_and_goes_on() -> None:
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    branch, end_of_branch = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    reading, writing = os.pipe()
    socket.send_fds(ours, [b'{"branch_in": 1}'], [end_of_branch.fileno()])
    socket.send_fds(ours, [b"{}"], [writing, os.open(os.devnull, os.O_WRONLY)])
    end_of_branch.close()
    os.close(writing)
    ours.close()
    assert fork_server.serve(theirs, fork_server.Hooks(LttngForkHooks(), fork_server.RunMark())) is None
    assert b"Resource temporarily unavailable" in branch.recv(1000)
    assert branch.recv(1000) == b""
    with pytest.raises(NotForked, match="Resource temporarily unavailable"):
        started_program(reading, 1.0)
    branch.close()
    theirs.close()


GRADER = """
import sys
from workbook.exercise.answers import Answer
from workbook.grading.judges import Job
from workbook.grading.slots.scheduler import judge_all

answer = Answer("import time\\ntime.sleep(600)\\n")
for job, judgement in judge_all([Job(one, "09_joint_positions", answer) for one in range(4)], 2, isolation=sys.argv[1]):
    pass
"""


@pytest.mark.parametrize("tier", [pytest.param("sandbox", marks=in_sandbox), "limits"])
def test_nothing_is_left_of_a_grader_that_is_killed(tier: Isolation) -> None:
    with subprocess.Popen([sys.executable, "-c", GRADER, tier]) as grader:
        wait_until(lambda: sum(is_asleep(pid) for pid in process_tree(grader.pid)) >= 2)
        below = process_tree(grader.pid)[1:]
        assert len(below) > 6
        grader.kill()
    wait_until(lambda: all(map(is_gone, below)))


def is_asleep(pid: int) -> bool:
    """Return whether a process has an answer's mark in its environment."""
    return any(
        line.startswith(b"WORKBOOK_RUN=") and line.strip(b" ") != b"WORKBOOK_RUN="
        for line in environment(pid)
    )


def test_many_answers_get_forked_slots_and_one_does_not(monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[bool] = []

    class Noted(Slot):
        def __init__(self, *arguments: Any, **more: Any) -> None:
            super().__init__(*arguments, **more)
            made.append(is_forked(self))

    monkeypatch.setattr(pool, "Slot", Noted)
    pool.warm_slots.close()
    broken = Answer("robot = = 1\n")
    for number, forked in ((1, False), (3, True)):
        made.clear()
        jobs = [Job(one, STEM, broken) for one in range(number)]
        assert all(judgement.status == "graded" for _, judgement in judge_all(jobs, 1))
        assert made == [forked]


@pytest.mark.whole
def test_where_answers_meet_each_other_no_server_is_started() -> None:
    assert pool.FORKED == ("sandbox", "limits")
    assert slot_server("uid") is None and slot_server("landlock") is None
