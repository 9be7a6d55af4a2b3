"""What one answer can do to another in the best tier: through a slot's state, and through what two programs share."""

import ctypes
import os
from collections.abc import Iterator
from contextlib import ExitStack
from itertools import product
from pathlib import Path

import pytest

from tests.programs.support import wait_until, write
from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.feedback.text import as_text
from workbook.grading.judges import Job
from workbook.grading.slots.client import Slot
from workbook.grading.slots.pool import slot_server
from workbook.grading.slots.scheduler import judge_all
from workbook.inside import proc
from workbook.isolation.bubblewrap import sandbox_problem
from workbook.isolation.sandbox import SandboxTier
from workbook.programs.fork_client import ForkServer
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.programs.usage import limit_exceeded
from workbook.recording.limits import ANSWER_LIMITS

pytestmark = [
    pytest.mark.whole,
    pytest.mark.sandbox,
    pytest.mark.slow,
    pytest.mark.skipif(sandbox_problem() is not None, reason=f"no sandbox: {sandbox_problem()}"),
]
ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
ATTACKERS, VICTIMS, SLOTS = 3, 16, 4
ENOUGH = 20
"""Each program has one of two random seeds, so this many equal seeds occur once in half a million times."""
SYS_KCMP, KCMP_FILE = 312, 0

LEAVES_SOCKETS = """
import socket

with open("/proc/net/unix") as table:
    names = {line.split()[7] for line in table.read().splitlines()[1:] if len(line.split()) > 7}
sent = 0
for name in sorted(names):
    held = [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(180)]
    numbers = [one.fileno() for one in held]
    for kind in (socket.SOCK_DGRAM, socket.SOCK_STREAM, socket.SOCK_SEQPACKET):
        with socket.socket(socket.AF_UNIX, kind) as sender:
            try:
                sender.setblocking(False)
                sender.connect(chr(0) + name[1:] if name.startswith("@") else name)
                sent += socket.send_fds(sender, [b"keep this"], numbers)
            except OSError:
                pass
print("sockets left:", sent, flush=True)
"""
MEDDLES_WITH_ITS_INPUT = """
import fcntl, os, signal, time
flags, number = fcntl.fcntl(0, fcntl.F_GETFL), fcntl.fcntl(0, fcntl.F_GETSIG)
fcntl.fcntl(0, fcntl.F_SETFL, os.O_NONBLOCK | os.O_APPEND)
fcntl.fcntl(0, fcntl.F_SETSIG, int(signal.SIGUSR1))
print(f"found {flags & (os.O_NONBLOCK | os.O_APPEND)} {number}\\n", end="", flush=True)
time.sleep(600)
"""
TELLS_ITS_SEED = "print('seed', hash('left arm'), flush=True)\n"


@pytest.fixture(scope="module")
def right_answer() -> str:
    return load_exercise(STEM, ROOT).source.solution_code


def test_no_right_answer_is_harmed_by_what_others_leave_in_its_slot(right_answer: str) -> None:
    """Three attackers among sixteen answers:

    what they send to a slot's sockets would count as the next answer's messages.
    """
    attacker = LEAVES_SOCKETS + right_answer
    jobs = [Job(f"right {number}", STEM, Answer(right_answer)) for number in range(VICTIMS)]
    for number in range(ATTACKERS):
        jobs.insert(5 * number, Job(f"attacker {number}", STEM, Answer(attacker)))
    judged = {job.key: one for job, one in judge_all(jobs, SLOTS, soak=False, isolation="sandbox")}
    for number in range(VICTIMS):
        one = judged[f"right {number}"]
        assert one.full_marks, f"{one.reason}\n{as_text(one)}"
    for number in range(ATTACKERS):
        recording = judged[f"attacker {number}"].recording
        assert recording is not None
        assert "sockets left: 0" in recording.process.log, recording.process.log


def test_what_was_there_before_is_not_counted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The judge's sockets and their unread data exist before a program starts, no matter which process left them."""
    found = {"sockets": 400, "queued": 70_000_000}
    monkeypatch.setattr(proc, "sockets_of_network", lambda: found["sockets"])
    monkeypatch.setattr(proc, "queued_bytes", lambda worth_counting: found["queued"])
    spec = ProgramSpec(write(tmp_path, "import time\ntime.sleep(600)\n"), limits=ANSWER_LIMITS)
    with NodeProcess(spec, 7, SandboxTier()) as program:
        assert limit_exceeded(ANSWER_LIMITS, [], program.confinement) is None
        found["sockets"] += 1 + (ANSWER_LIMITS.sockets or 0)
        assert limit_exceeded(ANSWER_LIMITS, [], program.confinement) == "sockets"


@pytest.fixture
def two_programs(tmp_path: Path) -> Iterator[list[NodeProcess]]:
    """Fork two programs from the same server into separate sandboxes, one after another."""
    with ExitStack() as stack:
        server = ForkServer()
        stack.callback(server.close)
        programs = []
        for name in ("one", "other"):
            (tmp_path / name).mkdir()
            spec = ProgramSpec(write(tmp_path / name, MEDDLES_WITH_ITS_INPUT), limits=ANSWER_LIMITS)
            programs.append(stack.enter_context(NodeProcess(spec, 7, SandboxTier(server))))
            wait_until(lambda: programs[-1].log.text().endswith("\n"), "it has looked at its input")
        yield programs


def test_what_a_program_sets_on_its_input_does_not_reach_another(two_programs: list[NodeProcess]) -> None:
    assert [one.log.text() for one in two_programs] == ["found 0 0\n"] * 2


def test_two_programs_have_no_open_file_and_no_memory_in_common(two_programs: list[NodeProcess]) -> None:
    """This includes the other processes of their sandboxes, whose descriptors a program can open."""
    one, other = (in_its_sandbox(program.pid) for program in two_programs)
    assert len(one) == len(other) > 1, "the program, and what keeps its sandbox"
    common = [
        f"{os.readlink(first)} as {first} and {second}"
        for mine, others in product(one, other)
        for first, second in product(descriptors(mine), descriptors(others))
        if is_one_file(first, second)
    ]
    assert common == []
    assert shared_memory(two_programs[0].pid) & shared_memory(two_programs[1].pid) == set()


@pytest.mark.parametrize("name", ["reads_its_own_memory", "becomes_the_first_process", "leaves_the_dead"])
def test_a_program_in_a_fresh_python_finds_no_more(name: str, tmp_path: Path) -> None:
    """If a fork server breaks, programs start without one, and their first process is bubblewrap."""
    text = (Path(__file__).parent / "answers" / f"{name}.py").read_text(encoding="utf-8")
    text = text.replace("@@GOOD@@", "print('it found nothing')").replace(
        '"net/unix", ', ""
    )  # here, this table is the machine's
    with NodeProcess(ProgramSpec(write(tmp_path, text), limits=ANSWER_LIMITS), 7, SandboxTier()) as program:
        assert program.wait(60.0)
        assert program.log.text().endswith("it found nothing\n"), program.log.text()


def in_its_sandbox(program: int) -> list[int]:
    """Return all processes in a program's PID namespace."""
    space = os.stat(f"/proc/{program}/ns/pid").st_ino
    return [
        pid for pid in map(int, filter(str.isdecimal, os.listdir("/proc"))) if process_space(pid) == space
    ]


def process_space(pid: int) -> int | None:
    try:
        return os.stat(f"/proc/{pid}/ns/pid").st_ino
    except OSError:
        return None


def descriptors(pid: int) -> list[str]:
    return [f"/proc/{pid}/fd/{number}" for number in os.listdir(f"/proc/{pid}/fd")]


def is_one_file(first: str, second: str) -> bool:
    """Return whether two descriptors in /proc are the same open file; without kcmp, compare their properties."""
    (_, _, pid, _, number), (_, _, other_pid, _, other) = first.split("/"), second.split("/")
    libc = ctypes.CDLL(None, use_errno=True)
    order = libc.syscall(SYS_KCMP, int(pid), int(other_pid), KCMP_FILE, int(number), int(other))
    if order >= 0:
        return order == 0
    looks = [(os.stat(one).st_dev, os.stat(one).st_ino, os.readlink(one)) for one in (first, second)]
    return looks[0] == looks[1] and "/dev/null" not in looks[0]


def shared_memory(pid: int) -> set[str]:
    """Return the device and inode of each file that is mapped as shared and writable."""
    lines = [line.split() for line in Path(f"/proc/{pid}/maps").read_text().splitlines()]
    return {f"{line[3]} {line[4]}" for line in lines if line[1][1] == "w" and line[1][3] == "s"}


def test_the_programs_of_one_slot_have_different_seeds_for_hashes() -> None:
    """If an answer depends on the order of a set, one seed for all programs would always give it the same verdict."""
    server = slot_server("sandbox")
    assert server is not None
    seeds: set[str] = set()
    judgements = 0
    with ExitStack() as stack:
        stack.callback(server.close)
        slot = stack.enter_context(Slot("sandbox", server=server))
        while len(seeds) < 2 and judgements < ENOUGH:
            judgements += 1
            judgement = slot.judge(STEM, Answer(TELLS_ITS_SEED), soak=False)
            assert judgement.recording is not None
            seeds.add(judgement.recording.process.log)
    assert len(seeds) == 2 and all("seed" in one for one in seeds), seeds
