"""The "limits" isolation tier, which only limits resources and kills the processes that a program leaves behind."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

from workbook.inside.orphans import sweep_orphans
from workbook.isolation.written_files import SharedMemory, WrittenFiles
from workbook.programs.tier import Confinement, Order, Started
from workbook.programs.unconfined import UnconfinedProgram


@dataclass(frozen=True)
class LimitedProgram(UnconfinedProgram):
    """A program with limits, in a working folder that's removed with its files. See `programs.tier.Confinement`."""

    @cached_property
    def written(self) -> WrittenFiles:
        """Counts the files that the program writes to its working folder, and their bytes."""
        return WrittenFiles(self.scratch)

    @cached_property
    def shared(self) -> SharedMemory:
        """Estimates the shared memory that the program has allocated. It must be created before the program starts."""
        return SharedMemory()

    def start(self, order: Order) -> Started:
        """Start the program as the base class does, but with its working folder as the folder for temporary files."""
        assert self.shared  # list the existing files first, because they aren't the program's own
        return super().start(replace(order, environ={**order.environ, "TMPDIR": str(self.scratch)}))

    def most_files(self, pids: Sequence[int]) -> int:
        """Return the number of files that the program has created in its working folder."""
        return self.written.look().files

    def stored_bytes(self, pids: Sequence[int]) -> int:
        """Return the larger of the numbers of bytes in the program's working folder and in its shared memory."""
        own = self.written.look().bytes
        return max(own, self.shared.bytes_of(pids, own))

    def sweep(self) -> bool:
        """Kill the processes that the program left behind. Return whether there were any. Raises StillThere."""
        return sweep_orphans() > 0


class LimitsTier:
    """The "limits" tier. See `workbook.programs.tier.Tier`.

    The process that uses this tier must adopt the processes that programs leave behind (see `adopt_orphans`). Apart
    from them and the programs, its fork server may be its only child, because `sweep` kills all other children.
    """

    def confine(self, scratch: Path) -> Confinement:
        """Return a confinement that limits resources and kills leftover processes, but doesn't hide any files."""
        return LimitedProgram(scratch)
