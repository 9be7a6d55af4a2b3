"""Any tier, with a memory cgroup for each program."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from workbook.isolation.memory_groups import MemoryGroup
from workbook.programs.tier import Confinement, Order, Started, Tier
from workbook.recording.limits import Limits


@dataclass
class GroupedProgram:
    """See `workbook.programs.tier.Confinement`: that of another tier, and a group below `folder`."""

    confined: Confinement
    folder: Path
    _group: MemoryGroup | None = field(default=None, init=False)

    def bring(self, file: Path, name: str) -> str:
        """As the tier does."""
        return self.confined.bring(file, name)

    def host_options(self, limits: Limits) -> list[str]:
        """As in the tier."""
        return self.confined.host_options(limits)

    def start(self, order: Order) -> Started:
        """Start the program in its tier and in a group. Without one where the kernel refuses it. Raises OSError."""
        if order.limits.memory is None:
            return self.confined.start(order)
        try:
            self._group = MemoryGroup(self.folder, order.limits)
        except OSError:  # its memory is watched all the same
            return self.confined.start(order)
        return self.confined.start(replace(order, cgroup_join_file=self._group.joins))

    def most_files(self, pids: Sequence[int]) -> int:
        """As in the tier."""
        return self.confined.most_files(pids)

    def stored_bytes(self, pids: Sequence[int]) -> int:
        """As in the tier."""
        return self.confined.stored_bytes(pids)

    def sockets(self, pids: Sequence[int]) -> int:
        """As in the tier."""
        return self.confined.sockets(pids)

    def queued_bytes(self, worth_counting: int) -> int:
        """As in the tier."""
        return self.confined.queued_bytes(worth_counting)

    def exceeded(self) -> str | None:
        """The limit of the group that the program has exceeded."""
        return None if self._group is None else self._group.exceeded()

    def unfiltered(self) -> str:
        """As in the tier."""
        return self.confined.unfiltered()

    def sweep(self) -> bool:
        """As the tier does."""
        return self.confined.sweep()

    def remove(self) -> None:
        """As the tier does; and remove the group."""
        self.confined.remove()
        if self._group is not None:
            self._group.remove()


@dataclass(frozen=True)
class GroupedTier:
    """See `workbook.programs.tier.Tier`. `folder`: the group of a slot (see `memory_groups`)."""

    tier: Tier
    folder: Path

    def confine(self, scratch: Path) -> Confinement:
        """The tier's confinement, in a group of its own."""
        return GroupedProgram(self.tier.confine(scratch), self.folder)
