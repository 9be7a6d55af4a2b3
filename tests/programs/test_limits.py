"""A program's limits: exceeding one ends the program, and the record names the limit."""

import os
import resource
from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest

from tests.programs.support import wait_until, write
from workbook.inside import proc
from workbook.inside.proc import memory_bytes
from workbook.isolation.sandbox import most_files
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.programs.usage import AT_EASE_S, WATCHFUL_S, limits_in_log, until_next_look_s
from workbook.recording.limits import ANSWER_LIMITS, Limits
from workbook.recording.recording import ProcessRecord
from workbook.ros.domains import lease_domain

MEGABYTE = 1_000_000


@pytest.fixture(scope="module")
def domain() -> Iterator[int]:
    with lease_domain() as lease:
        yield lease.domain_id


def ended(folder: Path, domain: int, program: str, **limits: int) -> ProcessRecord:
    """Return the record of a program under these limits, which ends without a request."""
    with NodeProcess(ProgramSpec(write(folder, program), limits=Limits(**limits)), domain) as process:
        assert process.wait(60.0), "nothing ended it"
        process.log.finish(1.0)
        return process.record()


def test_processor_time_that_is_used_up_is_named(tmp_path: Path, domain: int) -> None:
    record = ended(tmp_path, domain, "while True:\n    pass\n", cpu=1)
    assert (record.signal, record.limits_hit, record.ended_by) == ("SIGXCPU", ("cpu",), "itself")


def test_who_does_not_listen_to_the_end_of_its_time_is_killed(tmp_path: Path, domain: int) -> None:
    deaf = "import signal\nsignal.signal(signal.SIGXCPU, signal.SIG_IGN)\nwhile True:\n    pass\n"
    assert ended(tmp_path, domain, deaf, cpu=1).signal == "SIGKILL"


@pytest.mark.parametrize(
    ("program", "limit", "value", "named"),
    [
        ("held = bytes(2_000_000_000)", "memory", 1500 * MEGABYTE, "memory"),
        ("held = []\nwhile True:\n    held.append(open('/dev/null'))", "open_files", 64, "open_files"),
        ("open('much', 'wb').write(bytes(2_000_000))", "file_size", MEGABYTE, "file_size"),
    ],
)
def test_a_limit_of_the_kernel_is_named(
    program: str, limit: str, value: int, named: str, tmp_path: Path, domain: int
) -> None:
    record = ended(tmp_path, domain, program, **{limit: value})
    assert (record.exit, record.ended_by, record.limits_hit) == (1, "itself", (named,))


HOGS = """
import os, time
for _ in range(4):
    if os.fork() == 0:
        held = b"x" * 200_000_000
        time.sleep(600)
time.sleep(600)
"""


def test_memory_of_all_processes_together_is_limited(tmp_path: Path, domain: int) -> None:
    record = ended(tmp_path, domain, HOGS, processes=64, memory=700 * MEGABYTE)
    assert (record.limits_hit, record.ended_by) == (("memory",), "judge")


def test_what_processes_share_is_counted_once(
    tmp_path: Path, domain: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    sharing = """
        import os, time
        held = b"x" * 150_000_000
        pids = [os.getpid()]
        for _ in range(8):
            pid = os.fork()
            if pid == 0:
                time.sleep(600)
            pids.append(pid)
        print(*pids, flush=True)
        time.sleep(600)
    """
    looked: list[int] = []

    def noted(pids: Sequence[int], worth_counting: int) -> int:
        looked.append(memory_bytes(pids, worth_counting))
        return looked[-1]

    monkeypatch.setattr("workbook.programs.usage.memory_bytes", noted)
    limits = Limits(processes=64, memory=1200 * MEGABYTE)
    with NodeProcess(ProgramSpec(write(tmp_path, sharing), limits=limits), domain) as process:
        wait_until(lambda: process.log.text().endswith("\n"))
        pids = [int(word) for word in process.log.text().split()]
        assert memory_bytes(pids, 0) < 500 * MEGABYTE < memory_bytes(pids, 100_000 * MEGABYTE)
        before = len(looked)
        wait_until(lambda: len(looked) > before + 2)
        assert process.is_running()
    assert max(looked) < 1200 * MEGABYTE


def test_sockets_of_all_processes_together_are_limited(tmp_path: Path, domain: int) -> None:
    program = """
import os, socket, time
for _ in range(3):
    if os.fork() == 0:
        break
held = [socket.socket() for _ in range(10)]
time.sleep(60)
"""
    record = ended(tmp_path, domain, program, sockets=30, processes=64)
    assert (record.limits_hit, record.ended_by) == (("sockets",), "judge")


def test_threads_of_all_processes_together_are_limited(tmp_path: Path, domain: int) -> None:
    """If root runs the grader, no kernel limit counts them."""
    program = """
import os, threading, time
for _ in range(3):
    if os.fork() == 0:
        break
for _ in range(10):
    threading.Thread(target=time.sleep, args=(60,), daemon=True).start()
time.sleep(60)
"""
    record = ended(tmp_path, domain, program, threads=30, processes=64)
    assert (record.limits_hit, record.ended_by) == (("processes",), "judge")


def test_what_waits_in_sockets_is_added_up(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    head = "  sl  local_address rem_address   st tx_queue rx_queue tr\n"
    rows = [f"   {n}: 0100007F:1CE8 00000000:0000 07 {n:08X}:00100000 00:0\n" for n in range(2)]
    table, totals = tmp_path / "udp", tmp_path / "sockstat"
    table.write_text(head + "".join(rows))
    totals.write_text("sockets: used 54\nTCP: inuse 1 orphan 0 mem 1\nUDP: inuse 8 mem 999\nFRAG: memory 0\n")
    monkeypatch.setattr(proc, "QUEUE_TABLES", (str(table),))
    assert proc.sockets_of_network(str(totals)) == 54
    assert proc.queued_bytes(10, str(totals)) == 2 * 0x100000 + 1
    assert proc.queued_bytes(1000 * resource.getpagesize(), str(totals)) == 0
    assert (
        proc.queued_bytes(10, str(tmp_path / "none")) == proc.sockets_of_network(str(tmp_path / "none")) == 0
    )


def test_of_the_dead_nothing_is_counted() -> None:
    assert memory_bytes([2**22 + 1], 0) == 0
    assert most_files([2**22 + 1]) == 0


def test_files_of_the_machine_are_not_those_of_a_sandbox(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("workbook.isolation.sandbox.WRITABLE", ("/", "/usr"))
    assert most_files([os.getpid()]) == 0


def test_no_core_fits_into_what_an_answer_may_dump() -> None:
    assert 0 < (ANSWER_LIMITS.core or 0) < resource.getpagesize()


@pytest.mark.parametrize(
    ("log", "named"),
    [
        ("Traceback\n  File\nMemoryError\n", ("memory",)),
        ("terminate called after throwing an instance of 'std::bad_alloc'\n", ("memory",)),
        ("OSError: [Errno 24] Too many open files: 'x'\n\n", ("open_files",)),
        ("OSError: [Errno 28] No space left on device", ("disk",)),
        ("RuntimeError: can't start new thread", ("processes",)),
        ("MemoryError once\nand then\nall\nwas\nwell\n", ()),
        ("", ()),
    ],
)
def test_the_last_words_of_a_log_tell_the_limit(log: str, named: tuple[str, ...]) -> None:
    assert limits_in_log(log) == named


def test_processes_are_counted_whoever_starts_them(tmp_path: Path, domain: int) -> None:
    forks = "import os, time\nfor _ in range(40):\n    if os.fork() == 0:\n        time.sleep(600)\ntime.sleep(600)\n"
    with NodeProcess(ProgramSpec(write(tmp_path, forks), limits=Limits(processes=20)), domain) as process:
        assert process.wait(60.0)
        record = process.record()
    assert record.limits_hit == ("processes",)


def test_a_program_near_a_limit_is_looked_at_more_often() -> None:
    one = [os.getpid()]
    held = memory_bytes(one, 10**12)
    assert until_next_look_s(Limits(processes=64, memory=4 * held), one) == AT_EASE_S
    assert until_next_look_s(Limits(processes=64, memory=held * 3 // 2), one) == WATCHFUL_S
    assert until_next_look_s(Limits(processes=1, memory=4 * held), one) == WATCHFUL_S
    assert until_next_look_s(Limits(), one) == WATCHFUL_S
