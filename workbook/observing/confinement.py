"""What keeps a stranger's program in where bubblewrap cannot: a user id of its own, Landlock, or limits alone."""

import os
import shutil
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from workbook.observing.orphans import sweep_orphans
from workbook.observing.sandbox import NOT_FOR_ANSWERS, SYSTEM_FILES, SYSTEM_FOLDERS, interpreter_folders
from workbook.observing.uids import Ids

CONFINE = Path(__file__).with_name("confine.py")
READABLE_DEVICES = ("/dev/zero", "/dev/full", "/dev/random", "/dev/urandom")
SPARE_PROCESSES = 32
"""How many more the kernel allows than the bench does, so that the bench sees who has too many, and says so."""
NOT_FOR_STRANGERS = (*NOT_FOR_ANSWERS, "USER", "LOGNAME")
PROFILE = "FASTRTPS_DEFAULT_PROFILES_FILE"


@dataclass(frozen=True)
class Confinement:
    """How programs are kept in. `ids`: whose user they run as; `landlock`: hide the files of the machine.

    With neither they have resource limits and nothing else. `adopts`: this process adopts what they leave behind (see
    `adopt_orphans`), and has no other children but its fork server.
    """

    ids: Ids | None = None
    landlock: bool = False
    adopts: bool = False

    @property
    def shuts_in(self) -> bool:
        return self.ids is not None or self.landlock

    def host_limits(self, limits: Mapping[str, int]) -> dict[str, int]:
        """The limits that the kernel is to enforce on one process.

        Not that of processes: it would count everything that the same user runs, and nothing for root.
        """
        return {name: value for name, value in limits.items() if name != "processes"}

    def bring(self, path: Path, name: str, shelf: Path) -> Path:
        """Put a file on the shelf from which the program may read it, and nobody else's program."""
        if not self.shuts_in:
            return path.resolve()
        brought = shelf / name
        shutil.copyfile(path, brought)
        if self.ids is not None:
            for place, mode in ((shelf, 0o750), (brought, 0o440)):
                os.chown(place, 0, self.ids.user)
                place.chmod(mode)
        return brought

    def enter(
        self,
        command: Sequence[str],
        environ: Mapping[str, str],
        limits: Mapping[str, int],
        *,
        shelf: Path,
        scratch: Path,
    ) -> tuple[list[str], dict[str, str]]:
        """The command and the environment with which the program runs shut in; it may write to `scratch` only."""
        if not self.shuts_in:
            return [*command], {**environ}
        inside = {name: value for name, value in environ.items() if name not in NOT_FOR_STRANGERS}
        inside |= {"HOME": str(scratch), "TMPDIR": str(scratch), "ROS_LOG_DIR": str(scratch)}
        inside["PATH"] = "/usr/bin:/bin"
        if PROFILE in inside:  # one that cannot be read would let DDS talk to the whole network
            inside[PROFILE] = str(self.bring(Path(inside[PROFILE]), "profile.xml", shelf))
        wrapped = [sys.executable, "-I", "-S", str(CONFINE)]
        if self.ids is not None:
            os.chown(scratch, self.ids.user, self.ids.user)
            wrapped += ["--user", str(self.ids.user)]
            if "processes" in limits:
                wrapped += ["--processes", str(limits["processes"] + SPARE_PROCESSES)]
        if self.landlock:
            for path in (*SYSTEM_FOLDERS, *SYSTEM_FILES, *READABLE_DEVICES, *interpreter_folders(), shelf):
                wrapped += ["--read", str(path)]
            for path in (scratch, "/dev/null", *(("/dev/shm",) if self.ids is not None else ())):
                wrapped += ["--write", str(path)]
        return [*wrapped, "--", *command], inside

    def sweep(self) -> bool:
        """End whatever a program has left running, when it has ended itself. Returns whether there was anything.

        Raises StillThere when that is not possible.
        """
        left = self.ids is not None and self.ids.sweep()
        if self.adopts:
            left = sweep_orphans() > 0 or left
        return left
