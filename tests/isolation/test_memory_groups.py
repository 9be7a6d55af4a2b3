"""Memory cgroups: how they are found and created in a fake kernel, in both versions."""

import errno
import os
import subprocess
import sys
import tempfile
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from pathlib import Path

import pytest

from tests.programs.support import wait_until, write
from workbook.inside import group_keeper, memory_cgroup
from workbook.isolation import memory_groups
from workbook.isolation.grouped import GroupedTier
from workbook.isolation.memory_groups import (
    LEAF,
    PREFIX,
    Hierarchy,
    KeptGroup,
    LeasedGroups,
    MemoryGroup,
    NoMemoryGroups,
    find_hierarchy,
    prepare,
    sweep_groups,
    try_out,
)
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.programs.unconfined import Unconfined
from workbook.recording.limits import Limits

LIMITS = Limits(memory=1_500_000_000, queued=4_000_000)
FILES = {
    1: {
        "tasks": "",
        "cgroup.procs": "",
        "memory.limit_in_bytes": "9223372036854771712",
        "memory.memsw.limit_in_bytes": "9223372036854771712",
        "memory.kmem.tcp.limit_in_bytes": "9223372036854771712",
        "memory.kmem.tcp.usage_in_bytes": "0",
        "memory.oom_control": "oom_kill_disable 0\nunder_oom 0\noom_kill 0\n",
    },
    2: {
        "cgroup.procs": "",
        "cgroup.controllers": "cpu memory pids",
        "cgroup.subtree_control": "",
        "memory.max": "max",
        "memory.swap.max": "max",
        "memory.oom.group": "0",
        "memory.events": "low 0\nhigh 0\nmax 0\noom 0\noom_kill 0\noom_group_kill 0\n",
        "memory.stat": "anon 0\nfile 0\nsock 0\n",
    },
}
"""What the kernel puts into a new group."""
TABLES = {
    1: (
        "4:memory:{path}\n3:cpu,cpuacct:/elsewhere\n0::/\n",
        "30 20 0:26 {root} {mount} rw - cgroup cgroup rw,memory\n31 20 0:27 / /none rw - cgroup cgroup rw,cpu\n",
    ),
    2: ("0::{path}\n", "29 20 0:25 {root} {mount} rw,nosuid - cgroup2 cgroup2 rw,nsdelegate\n"),
}


class PaperKernel:
    """Creates and removes groups in an ordinary folder, with the files that a real kernel would put there."""

    def __init__(self, version: int, mount: Path, patch: pytest.MonkeyPatch) -> None:
        self.version = version
        self.own = mount / "session"
        self._rmdir, self._mkdir = os.rmdir, os.mkdir
        self.own.mkdir(parents=True)
        patch.setattr(memory_cgroup.os, "rmdir", self.rmdir)
        patch.setattr(os, "mkdir", self.mkdir)
        patch.setattr(memory_groups, "write", self.write)
        patch.setattr(memory_cgroup, "write", self.write)
        self._fill(self.own)

    def mkdir(self, path: str | Path, mode: int = 0o777) -> None:
        self._mkdir(path, mode)
        self._fill(Path(path))

    def _fill(self, group: Path) -> None:
        for name, text in FILES[self.version].items():
            (group / name).write_text(text)

    def rmdir(self, group: str) -> None:
        for path in Path(group).iterdir():
            if path.is_file():
                path.unlink()
        self._rmdir(group)

    def write(self, name: str, text: str) -> None:
        """Write as the kernel does.

        A group that contains processes can't be divided, and a process that joins a group leaves its old one.
        """
        path = Path(name)
        procs = path.parent / "cgroup.procs"
        if path.name == "cgroup.subtree_control":
            if procs.read_text().strip():
                raise OSError(errno.EBUSY, os.strerror(errno.EBUSY))
            text = text.removeprefix("+")
        if path.name == "cgroup.procs":
            for other in (*self.own.rglob("cgroup.procs"), self.own / "cgroup.procs"):
                other.write_text("".join(f"{pid}\n" for pid in other.read_text().split() if pid != text))
            text = procs.read_text() + f"{text}\n"
        if not path.is_file():
            raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(path))
        path.write_text(text)


@pytest.fixture(params=[1, 2])
def kernel(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> PaperKernel:
    return PaperKernel(request.param, tmp_path, monkeypatch)


@pytest.fixture
def second(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> PaperKernel:
    return PaperKernel(2, tmp_path, monkeypatch)


def tables_of(folder: Path, version: int, path: str, root: str = "/") -> tuple[str, str]:
    """Write two of the kernel's tables to files, and return their paths."""
    for name, text in zip(("groups", "mounts"), TABLES[version], strict=True):
        (folder / name).write_text(text.format(path=path, root=root, mount=folder))
    return str(folder / "groups"), str(folder / "mounts")


@pytest.mark.parametrize("version", [1, 2])
@pytest.mark.parametrize(("path", "root"), [("/session", "/"), ("/docker/a/session", "/docker/a")])
def test_the_group_of_this_process_is_found(version: int, path: str, root: str, tmp_path: Path) -> None:
    (tmp_path / "session").mkdir()
    found = find_hierarchy(*tables_of(tmp_path, version, path, root))
    assert found == Hierarchy(version, tmp_path, tmp_path / "session")


@pytest.mark.parametrize(
    ("path", "root"), [("/gone", "/"), ("/session", "/docker/a"), ("/../elsewhere", "/")]
)
def test_a_group_that_cannot_be_seen_is_none(path: str, root: str, tmp_path: Path) -> None:
    (tmp_path / "session").mkdir()
    with pytest.raises(NoMemoryGroups, match="no cgroup that can be seen"):
        find_hierarchy(*tables_of(tmp_path, 2, path, root))
    with pytest.raises(NoMemoryGroups, match="no cgroup that can be seen"):
        find_hierarchy(str(tmp_path / "none"), str(tmp_path / "none"))


def test_an_answer_gets_the_limits_of_the_one_object(kernel: PaperKernel) -> None:
    leased = LeasedGroups(prepare(Hierarchy(kernel.version, kernel.own.parent, kernel.own)))
    group = MemoryGroup(leased.path, LIMITS)
    written = {path.name: path.read_text() for path in group.path.iterdir()}
    if kernel.version == 1:
        assert written["memory.limit_in_bytes"] == written["memory.memsw.limit_in_bytes"] == "1500000000"
        assert written["memory.kmem.tcp.limit_in_bytes"] == "8000000", "the judge is first to see it"
        assert group.joins == str(group.path / "tasks")
    else:
        assert (written["memory.max"], written["memory.swap.max"]) == ("1500000000", "0")
        assert written["memory.oom.group"] == "1", "all of an answer goes at once"
        assert (leased.path / "cgroup.subtree_control").read_text() == "memory"
        assert group.joins == str(group.path / "cgroup.procs")
    assert group.path.parent == leased.path
    assert leased.path.parent == kernel.own, "below the group of the grader, whose limits go on to hold"
    assert group.exceeded() is None
    leased.remove()
    assert [path.name for path in kernel.own.iterdir() if path.is_dir()] == []


@pytest.mark.parametrize(
    ("named", "first", "second"),
    [
        (
            "memory",
            ("memory.oom_control", "oom_kill_disable 0\nunder_oom 0\noom_kill 2\n"),
            ("memory.events", "max 9\noom 1\noom_kill 1\noom_group_kill 1\n"),
        ),
        ("sockets", ("memory.kmem.tcp.usage_in_bytes", "4000001"), ("memory.stat", "anon 1\nsock 4000001\n")),
        (
            None,
            ("memory.kmem.tcp.usage_in_bytes", "4000000"),
            ("memory.events", "max 9\noom 0\noom_kill 0\n"),
        ),
    ],
)
def test_what_was_exceeded_is_named_also_when_the_group_is_gone(
    named: str | None, first: tuple[str, str], second: tuple[str, str], kernel: PaperKernel
) -> None:
    group = MemoryGroup(kernel.own, LIMITS)
    name, text = first if kernel.version == 1 else second
    (group.path / name).write_text(text)
    group.remove()
    assert not group.path.exists()
    assert group.exceeded() == named


def test_a_kernel_without_a_limit_of_swap_or_sockets_is_enough(
    kernel: PaperKernel, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in (
        "memory.memsw.limit_in_bytes",
        "memory.kmem.tcp.limit_in_bytes",
        "memory.swap.max",
        "memory.oom.group",
    ):
        monkeypatch.delitem(FILES[kernel.version], name, raising=False)
    assert MemoryGroup(kernel.own, LIMITS).exceeded() is None


def test_an_answer_whose_group_is_refused_runs_without_one(tmp_path: Path) -> None:
    spec = ProgramSpec(write(tmp_path, "print('it runs')"), limits=LIMITS)
    with NodeProcess(spec, 0, GroupedTier(Unconfined(), tmp_path / "there is none")) as process:
        assert process.wait(60.0)
    record = process.record()
    assert (record.exit, record.limits_hit) == (0, ())
    assert "it runs" in record.log


def test_a_group_whose_limit_cannot_be_set_is_removed(
    kernel: PaperKernel, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(path: str, text: str) -> None:
        raise PermissionError(errno.EACCES, "Permission denied", path)

    monkeypatch.setattr(memory_groups, "write", refuse)
    with pytest.raises(PermissionError):
        MemoryGroup(kernel.own, LIMITS)
    assert [path for path in kernel.own.iterdir() if path.is_dir()] == []


def test_in_version_2_a_grader_moves_to_a_leaf_of_its_own(second: PaperKernel) -> None:
    (second.own / "cgroup.procs").write_text(f"{os.getpid()}\n")
    assert prepare(Hierarchy(2, second.own.parent, second.own)) == second.own
    assert (second.own / LEAF / "cgroup.procs").read_text() == f"{os.getpid()}\n"
    assert (second.own / "cgroup.subtree_control").read_text() == "memory"
    assert prepare(Hierarchy(2, second.own.parent, second.own)) == second.own, "and does so once"


def test_in_version_2_nobody_elses_process_is_moved(second: PaperKernel) -> None:
    (second.own / "cgroup.procs").write_text(f"{os.getpid()}\n{os.getppid()}\n")
    with pytest.raises(NoMemoryGroups, match=r"may not be divided: Device or resource busy .*systemd-run"):
        prepare(Hierarchy(2, second.own.parent, second.own))
    assert (second.own / "cgroup.procs").read_text() == f"{os.getpid()}\n{os.getppid()}\n"
    assert not (second.own / LEAF).exists()


def test_in_version_2_the_controller_must_be_delegated(second: PaperKernel) -> None:
    (second.own / "cgroup.controllers").write_text("cpu pids")
    with pytest.raises(NoMemoryGroups, match=r"is not given the memory controller .*Delegate=memory"):
        prepare(Hierarchy(2, second.own.parent, second.own))


def test_a_group_that_nobody_can_make_or_join_is_told(
    kernel: PaperKernel, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(memory_groups, "_JOIN", ("false",))
    (kernel.own / "cgroup.subtree_control").touch()
    with pytest.raises(NoMemoryGroups, match="no process may join a group"):
        try_out(kernel.own)
    assert [path for path in kernel.own.iterdir() if path.is_dir()] == []

    def read_only(*_: object) -> None:
        raise OSError(errno.EROFS, os.strerror(errno.EROFS))

    monkeypatch.setattr(os, "mkdir", read_only)
    with pytest.raises(NoMemoryGroups, match=r"no group can be made in .*: Read-only file system"):
        try_out(kernel.own)


def test_an_old_kernel_that_counts_no_kills_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(FILES[1], "memory.oom_control", "oom_kill_disable 0\nunder_oom 0\n")
    with pytest.raises(NoMemoryGroups, match=r"older than 4\.13"):
        try_out(PaperKernel(1, tmp_path, monkeypatch).own)


@pytest.fixture
def without_groups(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Simulate a machine without memory cgroups."""
    missing = str(Path("/no/such/table"))
    monkeypatch.setattr(memory_groups, "find_hierarchy", lambda: find_hierarchy(missing, missing))
    memory_groups._groups_problem.cache_clear()
    monkeypatch.setattr(memory_groups, "_keeper", memory_groups._Keeper())
    yield
    memory_groups._groups_problem.cache_clear()


def test_slots_share_one_keeper_which_ends_with_the_last(
    tmp_path: Path, without_groups: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    both = threading.Barrier(2)
    made: list[Path] = []
    closed: list[Path] = []

    class Kept:
        def __init__(self, own: Path) -> None:
            made.append(own)
            with suppress(
                threading.BrokenBarrierError
            ):  # times out, because only one thread at a time should be here
                both.wait(0.5)
            self.path = own

        def close(self) -> None:
            closed.append(self.path)

    monkeypatch.setattr(memory_groups, "divide_group", lambda folder: None)
    monkeypatch.setattr(memory_groups, "find_hierarchy", lambda: Hierarchy(1, tmp_path, tmp_path))
    monkeypatch.setattr(memory_groups, "KeptGroup", Kept)
    monkeypatch.setattr(memory_groups, "try_out", lambda above: None)
    with ThreadPoolExecutor(2) as threads:
        first, second = [
            one.result() for one in [threads.submit(memory_groups.lease_groups) for _ in range(2)]
        ]
    assert first is not None and second is not None
    assert made == [tmp_path]
    first.remove()
    first.remove()
    assert closed == []
    second.remove()
    assert closed == [tmp_path]
    third = memory_groups.lease_groups()
    assert made == [tmp_path, tmp_path] and third is not None
    third.remove()
    assert closed == [tmp_path, tmp_path]


def test_without_a_cgroup_memory_is_watched_and_that_is_said(without_groups: None) -> None:
    assert memory_groups.lease_groups() is None
    assert memory_groups.groups_in_words() == (
        "Memory is watched 20 times a second, without a cgroup: this process is in no cgroup that can be seen."
    )


@pytest.fixture
def alive(tmp_path: Path) -> Iterator[KeptGroup]:
    """Provide a group that its keeper has created in an ordinary folder. Its tests don't need the fake kernel."""
    kept = KeptGroup(tmp_path)
    yield kept
    kept.close()
    assert not kept.path.exists()


def test_the_groups_of_killed_graders_are_swept_and_no_others(alive: KeptGroup, tmp_path: Path) -> None:
    deep = tmp_path / "deep"
    deep.mkdir()
    left = Path(tempfile.mkdtemp(prefix=f"{PREFIX}1-", dir=deep))
    (left / "slot-1" / "answer-1").mkdir(parents=True)
    sweep_groups(tmp_path)
    assert not left.exists()
    assert alive.path.is_dir(), "somebody keeps it"
    assert deep.is_dir()


def test_a_group_goes_with_its_grader_and_all_that_is_below(tmp_path: Path) -> None:
    """Even if the grader ends suddenly, the group's keeper notices that its own input is closed."""
    makes = (
        "import sys; from pathlib import Path; from workbook.isolation.memory_groups import KeptGroup, LeasedGroups; "
        "kept = KeptGroup(Path(sys.argv[1])); print(LeasedGroups(kept.path).path, flush=True); input()"
    )
    with subprocess.Popen(
        [sys.executable, "-c", makes, str(tmp_path)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as grader:
        assert grader.stdout is not None
        slot = Path(grader.stdout.readline().strip())
        assert slot.is_dir()
        assert slot.parent.parent == tmp_path
        sweep_groups(tmp_path)
        assert slot.is_dir()
        grader.kill()
    wait_until(lambda: list(tmp_path.iterdir()) == [], "its group goes")


def test_where_no_group_can_be_made_the_keeper_says_why(tmp_path: Path) -> None:
    with pytest.raises(NoMemoryGroups, match=r"no group can be made in .*: No such file or directory"):
        KeptGroup(tmp_path / "there is none")


def test_a_group_that_was_swept_before_it_was_locked_is_made_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    swept: list[str] = []
    mkdir = os.mkdir

    def sometimes(path: str) -> None:
        """Create no folder at the first call, as if another grader had already removed it."""
        if swept:
            mkdir(path)
        swept.append(path)

    monkeypatch.setattr(os, "mkdir", sometimes)
    group, lock = group_keeper.make_locked(str(tmp_path), PREFIX)
    os.close(lock)
    assert [len(swept), group] == [2, swept[-1]]
