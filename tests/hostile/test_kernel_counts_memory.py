"""The kernel's own memory limit, on a real kernel. Without cgroups, the tests show which limit applies instead.

The limits are small, so that no test takes much of the machine's memory.
"""

import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.programs.support import wait_until, write
from workbook.inside.orphans import adopt_orphans
from workbook.isolation.memory_groups import (
    PREFIX,
    LeasedGroups,
    find_hierarchy,
    groups_in_words,
    groups_problem,
    lease_groups,
)
from workbook.isolation.tiers import BEST_FIRST, Isolation, known_problem, lease_for, make_tier
from workbook.lab.health import check_sandbox
from workbook.programs.fork_client import ForkServer
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.recording.limits import MB, Limits
from workbook.recording.recording import ProcessRecord

pytestmark = [pytest.mark.sandbox, pytest.mark.slow, pytest.mark.whole]
FILES_IN_MEMORY = """
for folder in ("/tmp", "/dev/shm"):
    with open(f"{folder}/much", "wb") as file:
        for _ in range(55):
            file.write(bytes(1_000_000))
print("written", flush=True)
"""
MANY_SMALL_ONES = """
import os, time
for _ in range(8):
    if os.fork() == 0:
        held = b"x" * 40_000_000
        time.sleep(600)
time.sleep(600)
"""
HIDDEN_WATCHES = """
import os, select, socket, time
reading, _ = os.pipe()
numbers = [os.dup(reading) for _ in range(450)]
ours, theirs = socket.socketpair()
for _ in range(300):
    one = select.epoll()
    for number in numbers:
        one.register(number, select.EPOLLIN)
    socket.send_fds(ours, [b"x"], [one.fileno()])
    one.close()
print("hidden", flush=True)
time.sleep(1)
"""
LEAVES = """
import ctypes, glob, os, sys
libc = ctypes.CDLL(None, use_errno=True)

def works(attempt):
    try:
        return attempt() is not False
    except OSError:
        return False

def writes(path, text):
    def attempt():
        with open(path, "w") as file:
            file.write(text)
    return works(attempt)

def mounts():
    os.makedirs("groups", exist_ok=True)
    for kind, options in ((b"cgroup", b"memory"), (b"cgroup2", None)):
        if libc.mount(b"none", b"groups", kind, 0, options) == 0:
            return True
    return False

told = [line.rstrip().rsplit(":", 1)[1] for line in open("/proc/self/cgroup")]
found = ["mounts"] if works(mounts) else []
found += ["unshares"] if libc.unshare(0x02000000) == 0 else []
mounts_here = ("/sys/fs/cgroup", "/sys/fs/cgroup/memory")
for mount in (*mounts_here, *(f"/proc/1/root{mount}" for mount in mounts_here)):
    for path in {mount, *(mount + one for one in told), *(os.path.dirname(mount + one) for one in told)}:
        found += [
            f"{path}/{name}"
            for name in ("tasks", "cgroup.procs")
            if writes(f"{path}/{name}", str(os.getpid()))
        ]
        limits = [f"{path}/{name}" for name in ("memory.limit_in_bytes", "memory.max")]
        found += [limit for limit in limits if writes(limit, "-1")]
        if works(lambda: os.mkdir(f"{path}/mine")):
            found.append(path)
print("may change", found)
print("groups", sorted(set(told)), flush=True)
"""


def works_here(tier: Isolation) -> bool:
    """Return whether the tier works on this machine. If not, check that the tier's message gives the reason."""
    problem = known_problem(tier)
    if problem is None:
        return True
    reasons = {
        "sandbox": "bubblewrap|kernel",
        "uid": "only root|other users may not enter|too few user ids",
        "landlock": "has no Landlock",
    }
    assert re.search(reasons[tier], problem), problem
    return False


@pytest.fixture
def groups() -> Iterator[LeasedGroups | None]:
    leased = lease_groups()
    yield leased
    if leased is not None:
        assert leased.path.is_dir(), "its keeper was ended"
        leased.remove()
        assert not leased.path.exists(), "a group is left"


def record_of(
    program: str,
    tier: Isolation,
    groups: LeasedGroups | None,
    folder: Path,
    limits: Limits,
    warm: bool = False,
) -> ProcessRecord:
    """Return the record of a program that ends, or is ended, under these limits in a tier."""
    adopt_orphans()
    ids, server = lease_for(tier), ForkServer() if warm else None
    made = make_tier(tier, ids=ids, server=server, groups=None if groups is None else groups.path)
    try:
        with NodeProcess(ProgramSpec(write(folder, program), limits=limits), 0, made) as process:
            assert process.wait(60.0), "nothing ended it"
            if groups is not None:
                assert [path for path in groups.path.iterdir() if path.is_dir()], "it has no group"
        if groups is not None:
            assert not [path for path in groups.path.iterdir() if path.is_dir()], "its group is left"
        return process.record()
    finally:
        if server is not None:
            server.close()
        if ids is not None:
            ids.release()


@pytest.mark.parametrize("warm", [True, False], ids=["forked", "in a fresh Python"])
def test_files_in_memory_count_as_memory_or_are_bounded_by_their_folders(
    warm: bool, groups: LeasedGroups | None, tmp_path: Path
) -> None:
    if not works_here("sandbox"):
        return
    limits = Limits(memory=90 * MB, processes=64)
    record = record_of(FILES_IN_MEMORY, "sandbox", groups, tmp_path, limits, warm)
    if groups is None:
        assert groups_problem()
        assert (record.exit, record.limits_hit) == (0, ()), "two folders of 64 MiB, and no more"
        assert "written" in record.log
    else:
        assert (record.limits_hit, record.ended_by) == (("memory",), "judge")
        assert record.signal == "SIGKILL"
        assert "written" not in record.log


@pytest.mark.parametrize("tier", BEST_FIRST)
def test_what_the_kernel_keeps_is_counted_where_no_table_of_descriptors_shows_it(
    tier: Isolation, groups: LeasedGroups | None, tmp_path: Path
) -> None:
    """Epoll instances in a socket that is never read.

    What they watch counts toward one limit per user, for all programs.
    """
    if not works_here(tier):
        return
    limits = Limits(memory=2500 * MB, processes=64, descriptors=4000, watches=4000, kernel=15 * MB)
    record = record_of(HIDDEN_WATCHES, tier, groups, tmp_path, limits)
    if groups is None:
        assert groups_problem()
        assert (record.exit, record.limits_hit) == (0, ())
    else:
        assert (record.limits_hit, record.ended_by) == (("descriptors",), "judge"), record.log


@pytest.mark.parametrize("tier", BEST_FIRST)
def test_memory_of_many_processes_together_ends_them_in_every_tier(
    tier: Isolation, groups: LeasedGroups | None, tmp_path: Path
) -> None:
    """The kernel or the watching judge ends them, with the same message."""
    if not works_here(tier):
        return
    record = record_of(MANY_SMALL_ONES, tier, groups, tmp_path, Limits(memory=200 * MB, processes=64))
    assert (record.limits_hit, record.ended_by) == (("memory",), "judge")


@pytest.mark.parametrize("tier", [one for one in BEST_FIRST if one != "limits"])
def test_no_answer_leaves_its_group_or_raises_its_limit(
    tier: Isolation, groups: LeasedGroups | None, tmp_path: Path
) -> None:
    """This doesn't apply to "limits", which hides nothing.

    There, only the judge watches the memory, as the manual says.
    """
    if not works_here(tier):
        return
    record = record_of(LEAVES, tier, groups, tmp_path, Limits(memory=2500 * MB, processes=64))
    assert record.exit == 0, record.log
    assert "may change []" in record.log, record.log
    if tier == "sandbox":
        assert "groups ['/']" in record.log, "its path would tell that it is judged"


SLOT = """
import sys
from workbook.grading.slots.client import Slot
slot = Slot("sandbox")
print(slot._groups and slot._groups.path, flush=True)
slot._read_line(0.0, 1e12)
print("ready", flush=True)
sys.stdin.read()
"""


def test_no_group_outlives_a_grader_that_is_killed() -> None:
    if not works_here("sandbox"):
        return
    with subprocess.Popen(
        [sys.executable, "-c", SLOT], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as grader:
        assert grader.stdout is not None
        folder = grader.stdout.readline().strip()
        assert grader.stdout.readline() == "ready\n"
        if groups_problem() is None:
            assert Path(folder).is_dir()
        else:
            assert folder == "None"
        grader.kill()
    if groups_problem() is None:
        kept = f"{PREFIX}{grader.pid}-*"
        wait_until(
            lambda: not list(find_hierarchy().own.glob(kept)), "the group of the slot and all above it go"
        )
        assert not Path(folder).exists()


def test_the_doctor_says_how_memory_is_limited() -> None:
    told = groups_in_words()
    assert told in check_sandbox().saw
    if groups_problem() is None:
        assert told == f"Memory is limited by a cgroup (version {find_hierarchy().version})."
    else:
        assert told.startswith("Memory is watched 20 times a second, without a cgroup: ")
