"""The "limits" tier: it limits resources, and kills the processes that a program leaves behind."""

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
    """A program with limits, in a folder that's removed with its files. See `workbook.programs.tier.Confinement`."""

    @cached_property
    def written(self) -> WrittenFiles:
        """Measures the files that the program writes to its working folder."""
        return WrittenFiles(self.scratch)

    @cached_property
    def shared(self) -> SharedMemory:
        """Measures the shared memory that has been allocated since the program was started."""
        return SharedMemory()

    def start(self, order: Order) -> Started:
        """Start the program like the base class, but with its working folder as the folder for temporary files."""
        assert self.shared  # remember the files from before it began, which aren't its own
        return super().start(replace(order, environ={**order.environ, "TMPDIR": str(self.scratch)}))

    def most_files(self, pids: Sequence[int]) -> int:
        """Return how many files the program has created in its working folder."""
        return self.written.look().files

    def stored_bytes(self, pids: Sequence[int]) -> int:
        """Return how many bytes the program has written to its working folder, and to shared memory."""
        own = self.written.look().bytes
        return max(own, self.shared.bytes_of(pids, own))

    def sweep(self) -> bool:
        """Kill the processes that the program left behind. Return whether there were any. Raises StillThere."""
        return sweep_orphans() > 0


class LimitsTier:
    """The "limits" tier. See `workbook.programs.tier.Tier`.

    This process must adopt the processes that programs leave behind (see `adopt_orphans`). Its only other child may be
    its fork server.
    """

    def confine(self, scratch: Path) -> Confinement:
        """Return a confinement that limits resources, hides no files, and kills leftover processes."""
        return LimitedProgram(scratch)
