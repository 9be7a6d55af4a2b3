"""Add a memory cgroup per program to any tier."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from workbook.isolation.memory_groups import MemoryGroup
from workbook.programs.tier import Confinement, Order, Started, Tier
from workbook.recording.limits import Limits


@dataclass
class GroupedProgram:
    """A program in another tier's confinement, and in its own group below `folder`.

    See `workbook.programs.tier.Confinement`.
    """

    confined: Confinement
    folder: Path
    _group: MemoryGroup | None = field(default=None, init=False)

    def bring(self, file: Path, name: str) -> str:
        """Let the tier bring a file."""
        return self.confined.bring(file, name)

    def host_options(self, limits: Limits) -> list[str]:
        """Return the tier's options."""
        return self.confined.host_options(limits)

    def start(self, order: Order) -> Started:
        """Start the program in its tier and in a group, or without a group if the kernel refuses it. Raises OSError."""
        if order.limits.memory is None:
            return self.confined.start(order)
        try:
            self._group = MemoryGroup(self.folder, order.limits)
        except OSError:  # the judge still polls its memory
            return self.confined.start(order)
        return self.confined.start(replace(order, cgroup_join_file=self._group.joins))

    def most_files(self, pids: Sequence[int]) -> int:
        """Return the tier's result."""
        return self.confined.most_files(pids)

    def stored_bytes(self, pids: Sequence[int]) -> int:
        """Return the tier's result."""
        return self.confined.stored_bytes(pids)

    def sockets(self, pids: Sequence[int]) -> int:
        """Return the tier's result."""
        return self.confined.sockets(pids)

    def queued_bytes(self, worth_counting: int) -> int:
        """Return the tier's result."""
        return self.confined.queued_bytes(worth_counting)

    def exceeded(self) -> str | None:
        """Return which of the group's limits the program has exceeded; None if there's no group or no such limit."""
        return None if self._group is None else self._group.exceeded()

    def unfiltered(self) -> str:
        """Return the tier's reason."""
        return self.confined.unfiltered()

    def sweep(self) -> bool:
        """Let the tier sweep."""
        return self.confined.sweep()

    def remove(self) -> None:
        """Let the tier clean up, and then remove the group."""
        self.confined.remove()
        if self._group is not None:
            self._group.remove()


@dataclass(frozen=True)
class GroupedTier:
    """Adds a group to each program of `tier`; see `workbook.programs.tier.Tier`. `folder`: a slot's group."""

    tier: Tier
    folder: Path

    def confine(self, scratch: Path) -> Confinement:
        """Return the tier's confinement, in a new group."""
        return GroupedProgram(self.tier.confine(scratch), self.folder)
