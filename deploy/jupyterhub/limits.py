"""Limit the memory, CPU time, and processes of a student's server with cgroups, version 1 or 2.

Without writable cgroups, nothing limits total memory and CPU time. The number of processes is limited in any case,
because each student has a separate user ID (RLIMIT_NPROC).
"""

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from workbook.inside.memory_cgroup import PROCESSES, remove_group, write
from workbook.inside.proc import mounted, own_groups
from workbook.isolation.memory_groups import NoMemoryGroups, find_hierarchy, prepare

PERIOD_US = 100_000
PREFIX = "rclpy-class-"


@dataclass(frozen=True)
class Limits:
    """The limits of one server. None means no limit.

    `memory`: in bytes. `processors`: how many it may use. `processes`: how many it may have, including threads.
    """

    memory: int | None
    processors: float | None
    processes: int | None

    def of_version_1(self) -> Mapping[str, Mapping[str, int]]:
        """For version 1, return each controller's files, with the values to write into them."""
        quota = {} if self.processors is None else {"cpu.cfs_quota_us": int(self.processors * PERIOD_US)}
        memory = {} if self.memory is None else {"memory.limit_in_bytes": self.memory}
        processes = {} if self.processes is None else {"pids.max": self.processes}
        return {"memory": memory, "cpu": quota, "pids": processes}

    def of_version_2(self) -> Mapping[str, str]:
        """For version 2, return the files of the server's only group, with the values to write into them."""
        files: dict[str, str] = {}
        if self.memory is not None:
            files |= {"memory.max": str(self.memory), "memory.swap.max": "0"}
        if self.processors is not None:
            files["cpu.max"] = f"{int(self.processors * PERIOD_US)} {PERIOD_US}"
        if self.processes is not None:
            files["pids.max"] = str(self.processes)
        return files


def make_groups(name: str, limits: Limits) -> list[Path]:
    """Create a server's cgroups, leaving out any that can't be created.

    A process joins a group by writing its ID to the group's `cgroup.procs`.
    """
    try:
        hierarchy = find_hierarchy()
        above = prepare(hierarchy)
    except NoMemoryGroups:
        return []
    if hierarchy.version == 2:
        with suppress(OSError):
            write(str(above / "cgroup.subtree_control"), "+cpu +pids")
        return _made(above / f"{PREFIX}{name}", limits.of_version_2())
    return [
        group
        for controller, files in limits.of_version_1().items()
        for own in _own_group(controller)
        for group in _made(own / f"{PREFIX}{name}", files)
    ]


def join_files(groups: list[Path]) -> list[str]:
    """Return the files to which a process must write its ID to join the groups."""
    return [str(group / PROCESSES) for group in groups]


def remove_groups(groups: list[Path]) -> None:
    """Kill the groups' remaining processes, and remove the groups."""
    for group in groups:
        remove_group(str(group))


def _made(group: Path, files: Mapping[str, object]) -> list[Path]:
    try:
        remove_group(str(group))
        group.mkdir()
        for name, value in files.items():
            with suppress(
                FileNotFoundError
            ):  # no swap accounting, or a controller that wasn't delegated to us
                write(str(group / name), str(value))
    except OSError:
        remove_group(str(group))
        return []
    return [group]


def _own_group(controller: str) -> list[Path]:
    for _, controllers, path in own_groups():
        if controller in controllers.split(","):
            for root, mount, options in mounted("cgroup"):
                own = Path(mount, path.removeprefix(root).lstrip("/"))
                if controller in options and own.is_dir():
                    return [own]
    return []
