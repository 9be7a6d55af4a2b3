"""The tier "limits": resource limits, and an end to all that a program has started."""

from dataclasses import dataclass
from pathlib import Path

from workbook.inside.orphans import sweep_orphans
from workbook.programs.tier import Confinement
from workbook.programs.unconfined import UnconfinedProgram


@dataclass(frozen=True)
class LimitedProgram(UnconfinedProgram):
    """See `workbook.programs.tier.Confinement`."""

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
