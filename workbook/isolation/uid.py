"""The "uid" isolation tier, which requires root and runs each slot's programs under a separate user ID.

A slot is a process that judges answers. If the kernel has Landlock, the tier also hides files.
"""

import os
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from workbook.inside.landlock import landlock_abi
from workbook.inside.orphans import sweep_orphans
from workbook.isolation.landlock import ConfinedProgram
from workbook.isolation.user_ids import Ids, shared_folders
from workbook.isolation.written_files import WrittenFiles
from workbook.programs.tier import Confinement, threads_of_libraries
from workbook.recording.limits import ENDED_PROCESSES, Limits
from workbook.ros.scratch import scratch_folder

EXTRA_PROCESSES = 32
"""The kernel's limit on processes is higher than the judge's by this number, so that the judge can report an excess."""


@dataclass(frozen=True, kw_only=True)
class UserProgram(ConfinedProgram):
    """A program that runs as the user `ids.user`. See `workbook.programs.tier.Confinement`.

    `sweeps_orphans`: whether this process adopts the processes that programs leave behind (see `adopt_orphans`), and
    may kill all of its children, except those passed to `orphans.exempt`.
    """

    ids: Ids
    sweeps_orphans: bool = True

    def bring(self, file: Path, name: str) -> str:
        """Copy the file to a folder that only root and the program's user can read. Return the copy's path."""
        brought = super().bring(file, name)
        for place, mode in ((str(self.files), 0o750), (brought, 0o440)):
            os.chown(place, 0, self.ids.user)
            os.chmod(place, mode)
        return brought

    def give(self) -> Path:
        """Create the package as the base class does, but in folders that only root and the program's user can read."""
        package = super().give()
        for folder in (package.parent, package):
            os.chown(folder, 0, self.ids.user)
            os.chmod(folder, 0o750)
        return package

    def options(self, limits: Limits) -> list[str]:
        """Return the base class's options, the user ID, and the process limit.

        As a side effect, make the program's user the owner of `scratch`.
        """
        os.chown(self.scratch, self.ids.user, self.ids.user)
        options = ["--user", str(self.ids.user)]
        if limits.processes is not None:
            allowed = limits.processes + EXTRA_PROCESSES + ENDED_PROCESSES + threads_of_libraries()
            options += ["--processes", str(allowed)]
        return options + super().options(limits)

    def writable(self) -> tuple[str, ...]:
        """Return the base class's paths, and the shared memory folder that DDS uses."""
        return (*super().writable(), "/dev/shm")

    @cached_property
    def written(self) -> WrittenFiles:
        """Counts the program's files in `scratch`, and its user's files in world-writable folders."""
        return WrittenFiles(self.scratch, shared_folders(), self.ids.user)

    def sweep(self) -> bool:
        """Kill all of the user's processes and all processes that the program left behind.

        Return whether there were any. Raises StillThere if one of them can't be killed.
        """
        left = self.ids.sweep()
        return (self.sweeps_orphans and sweep_orphans() > 0) or left


@dataclass(frozen=True)
class UidTier:
    """The "uid" tier. See `workbook.programs.tier.Tier`.

    `ids`: the user IDs, leased by the caller. `hides_files` and `sweeps_orphans`: see `UserProgram`.
    """

    ids: Ids
    hides_files: bool = field(default_factory=lambda: landlock_abi() > 0)
    sweeps_orphans: bool = True

    def confine(self, scratch: Path) -> Confinement:
        """Return a confinement that runs the program as the leased user."""
        return UserProgram(
            scratch,
            scratch_folder("files"),
            self.hides_files,
            ids=self.ids,
            sweeps_orphans=self.sweeps_orphans,
        )
