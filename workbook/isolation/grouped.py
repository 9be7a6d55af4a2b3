"""Extend any isolation tier by a memory cgroup for each program."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from workbook.isolation.memory_groups import MemoryGroup
from workbook.programs.tier import Confinement, Order, Started, Tier
from workbook.recording.limits import Limits


@dataclass
class GroupedProgram:
    """Runs a program in a tier's confinement (`confined`), and also in its own memory cgroup inside the group `folder`.

    See `workbook.programs.tier.Confinement`.
    """

    confined: Confinement
    folder: Path
    _group: MemoryGroup | None = field(default=None, init=False)

    def bring(self, file: Path, name: str) -> str:
        """Make the file readable as the tier's confinement does, and return its path."""
        return self.confined.bring(file, name)

    def host_options(self, limits: Limits) -> list[str]:
        """Return the options that the tier's confinement returns."""
        return self.confined.host_options(limits)

    def start(self, order: Order) -> Started:
        """Start the program in its tier and in a group, or without a group if none can be created.

        There is also no group for a program without a memory limit. Raises OSError if the program can't be started.
        """
        if order.limits.memory is None:
            return self.confined.start(order)
        try:
            self._group = MemoryGroup(self.folder, order.limits)
        except OSError:  # the judge still polls the program's memory
            return self.confined.start(order)
        return self.confined.start(replace(order, cgroup_join_file=self._group.joins))

    def most_files(self, pids: Sequence[int]) -> int:
        """Return the result from the tier's confinement."""
        return self.confined.most_files(pids)

    def stored_bytes(self, pids: Sequence[int]) -> int:
        """Return the result from the tier's confinement."""
        return self.confined.stored_bytes(pids)

    def sockets(self, pids: Sequence[int]) -> int:
        """Return the result from the tier's confinement."""
        return self.confined.sockets(pids)

    def queued_bytes(self, worth_counting: int) -> int:
        """Return the result from the tier's confinement."""
        return self.confined.queued_bytes(worth_counting)

    def exceeded(self) -> str | None:
        """Return the limit of its group that the program has exceeded, or None if it exceeded none or has no group."""
        return None if self._group is None else self._group.exceeded()

    def unfiltered(self) -> str:
        """Return why the tier can't filter system calls, or an empty string (see `Confinement`)."""
        return self.confined.unfiltered()

    def sweep(self) -> bool:
        """Kill leftover processes as the tier's confinement does, and return its result."""
        return self.confined.sweep()

    def remove(self) -> None:
        """Clean up as the tier's confinement does, and then remove the group."""
        self.confined.remove()
        if self._group is not None:
            self._group.remove()


@dataclass(frozen=True)
class GroupedTier:
    """Runs each program in `tier`, and also in its own memory cgroup inside a slot's group, `folder`.

    See `workbook.programs.tier.Tier`.
    """

    tier: Tier
    folder: Path

    def confine(self, scratch: Path) -> Confinement:
        """Return the tier's confinement, extended by a memory cgroup that `start` creates."""
        return GroupedProgram(self.tier.confine(scratch), self.folder)
