"""The "landlock" isolation tier: the kernel hides all files that a program doesn't need. It doesn't require root."""

import os
import shutil
import sys
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from workbook.inside import RUN, proc
from workbook.inside.orphans import sweep_orphans
from workbook.inside.syscall_filter import filter_problem
from workbook.isolation.host_files import (
    NOT_FOR_ANSWERS,
    PATH_OF_PROGRAMS,
    SYSTEM_FILES,
    SYSTEM_FOLDERS,
    given_files,
    interpreter_folders,
)
from workbook.isolation.written_files import WrittenFiles
from workbook.programs.process import PROFILE
from workbook.programs.tier import Confinement, Order, Started, limit_options
from workbook.programs.unconfined import KERNEL_LIMITS, FreshProgram, host_command, joining
from workbook.recording.limits import Limits
from workbook.ros.scratch import remove_scratch, scratch_folder

READABLE_DEVICES = ("/dev/zero", "/dev/full", "/dev/random", "/dev/urandom")
NOT_FOR_OTHER_USERS = (*NOT_FOR_ANSWERS, "USER", "LOGNAME")


@dataclass(frozen=True)
class ConfinedProgram:
    """A program whose process `inside/confine.py` confines before the program starts. See `programs.tier.Confinement`.

    The program reads its files from a separate folder (`files`), and may write to its working folder (`scratch`).
    `hides_files`: whether Landlock hides all files that the program doesn't need.
    """

    scratch: Path
    files: Path
    hides_files: bool = True

    def bring(self, file: Path, name: str) -> str:
        """Copy the file into `files`. Return the copy's path."""
        brought = self.files / name
        shutil.copyfile(file, brought)
        return str(brought)

    def host_options(self, limits: Limits) -> list[str]:
        """Return options for the limits that the kernel enforces per process."""
        return limit_options(limits, KERNEL_LIMITS)

    def start(self, order: Order) -> Started:
        """Start the program in a new Python interpreter that `inside/confine.py` confines first. Raises OSError."""
        command = host_command("--parent", str(os.getpid()), *order.arguments)
        environ = self.environment(order.environ)
        confined = [sys.executable, "-I", "-S", str(RUN), "confine", *self.options(order.limits), "--"]
        wrapped = joining(order.cgroup_join_file, [*confined, *command])
        began = time.monotonic()
        return Started(
            FreshProgram(wrapped, environ, self.scratch, order.output_fd, input_fd=order.input_fd), began
        )

    def environment(self, environ: Mapping[str, str]) -> dict[str, str]:
        """Return the environment for the program: without the judge's variables, and with paths that it can read."""
        inside = {name: value for name, value in environ.items() if name not in NOT_FOR_OTHER_USERS}
        inside |= {name: str(self.scratch) for name in ("HOME", "TMPDIR", "ROS_LOG_DIR")}
        inside["PATH"] = PATH_OF_PROGRAMS
        profile = inside.get(PROFILE)
        if profile is not None and Path(profile).parent != self.files:
            # If DDS couldn't read the profile, it would use the whole network.
            inside[PROFILE] = self.bring(Path(profile), "profile.xml")
        inside["PYTHONPATH"] = str(self.give().parent)
        return inside

    def give(self) -> Path:
        """Create a `workbook` package of links to the parts that an answer may import. Return its folder.

        To find a package, Python lists the folder that contains the package. The answer can't list the course's folder,
        because that folder is hidden, so it needs another folder.
        """
        package = self.files / "given" / "workbook"
        package.mkdir(parents=True, exist_ok=True)
        for file in given_files():
            link = package / file.name
            if not link.is_symlink():
                link.symlink_to(file)
        return package

    def options(self, limits: Limits) -> list[str]:
        """Return the options for `confine.py`."""
        if not self.hides_files:
            return []
        readable = (*SYSTEM_FOLDERS, *SYSTEM_FILES, *READABLE_DEVICES, *interpreter_folders(), self.files)
        options = [part for path in readable for part in ("--read", str(path))]
        return options + [part for path in self.writable() for part in ("--write", str(path))]

    def writable(self) -> tuple[str, ...]:
        """Return the paths that the program may write to."""
        return (str(self.scratch), os.devnull)

    @cached_property
    def written(self) -> WrittenFiles:
        """Counts the files that the program writes, and their bytes."""
        return WrittenFiles(self.scratch)

    def most_files(self, pids: Sequence[int]) -> int:
        """Return the number of files that the program has created, in all folders together."""
        return self.written.look().files

    def stored_bytes(self, pids: Sequence[int]) -> int:
        """Return the number of bytes in the program's files."""
        return self.written.look().bytes

    def sockets(self, pids: Sequence[int]) -> int:
        """Return the number of sockets that these processes have open."""
        return proc.sockets_open(pids)

    def queued_bytes(self, worth_counting: int) -> int:
        """Return zero, because the program shares the machine's network with other programs."""
        return 0

    def exceeded(self) -> str | None:
        """Return None, because this tier has no memory cgroup."""
        return None

    def unfiltered(self) -> str:
        """Return why system calls can't be filtered on this machine, or an empty string if they can."""
        return filter_problem()

    def sweep(self) -> bool:
        """Kill the processes that the program left behind. Return whether there were any. Raises StillThere."""
        return sweep_orphans() > 0

    def remove(self) -> None:
        """Remove the folder that `bring` copies files to."""
        remove_scratch(self.files)


class LandlockTier:
    """The "landlock" tier. See `workbook.programs.tier.Tier`.

    The process that uses this tier must meet the same requirements as for `LimitsTier`.
    """

    def confine(self, scratch: Path) -> Confinement:
        """Return a confinement with a separate folder for the files that the program reads."""
        return ConfinedProgram(scratch, scratch_folder("files"))
