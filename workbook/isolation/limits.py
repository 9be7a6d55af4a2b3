"""The tier "limits": resource limits, and an end to all that a program has started."""

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
    """See `workbook.programs.tier.Confinement`. What the program writes to its temporary folder goes with it."""

    @cached_property
    def written(self) -> WrittenFiles:
        """What the program writes to the folder that it works in."""
        return WrittenFiles(self.scratch)

    @cached_property
    def shared(self) -> SharedMemory:
        """What has come to shared memory since the program began."""
        return SharedMemory()

    def start(self, order: Order) -> Started:
        """See `UnconfinedProgram`; temporary files go to the folder that the program works in."""
        assert self.shared  # what is there before it begins is not its own
        return super().start(replace(order, environ={**order.environ, "TMPDIR": str(self.scratch)}))

    def most_files(self, pids: Sequence[int]) -> int:
        """How many files the program has made in the folder that it works in."""
        return self.written.look().files

    def stored_bytes(self, pids: Sequence[int]) -> int:
        """What the program has written to the folder that it works in, and to shared memory."""
        own = self.written.look().bytes
        return max(own, self.shared.bytes_of(pids, own))

    def sweep(self) -> bool:
        """Kill the processes that the program left behind. Returns whether there were any. Raises StillThere."""
        return sweep_orphans() > 0


class LimitsTier:
    """See `workbook.programs.tier.Tier`.

    For a process that adopts what programs leave behind (see `adopt_orphans`), and has no other children but its fork
    server.
    """

    def confine(self, scratch: Path) -> Confinement:
        """A confinement that limits resources, hides no files, and kills what the program leaves behind."""
        return LimitedProgram(scratch)
