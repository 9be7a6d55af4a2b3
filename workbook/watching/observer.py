"""Lease a ROS domain on which programs are watched, one after another."""

from collections.abc import Container

from workbook.programs.tier import Tier
from workbook.ros.domains import DomainLease, NoDomainFree, lease_domain
from workbook.ros.environment import is_prepared, prepare
from workbook.watching.recorder import OnTake


class Observer:
    """Leases a domain on which programs are watched, one after another (see `workbook.watching.watch`).

    `tier`: the isolation tier of the programs, or None for no isolation. `on_take`: the function to call whenever
    messages have been taken, or None. Each grading slot has one observer. After a program was killed, the observer
    moves to another domain, because a killed program's nodes stay in the graph for a while.
    """

    on_take: OnTake | None = None

    def __init__(self, lease: DomainLease | None = None, tier: Tier | None = None) -> None:
        self.tier = tier
        self._lease: DomainLease | None = None
        self._use(lease or lease_domain())

    def _use(self, lease: DomainLease) -> None:
        self._lease = lease
        if not is_prepared():
            prepare(domain_id=lease.domain_id)

    @property
    def domain_id(self) -> int:
        """The leased ROS domain. Don't use it after `close`."""
        assert self._lease is not None, "this observer is closed"
        return self._lease.domain_id

    def close(self) -> None:
        """Release the domain."""
        if self._lease is not None:
            self._lease.release()
            self._lease = None

    def move(self) -> None:
        """Lease another domain.

        The current one isn't used for a while, because killed programs are still in its graph.
        """
        if self._lease is not None:
            self._lease.release(killed=True)
        self._use(lease_domain())

    def keep_off(self, domains: Container[int]) -> None:
        """Move to another domain if the current one is in `domains`, unless no domain is free."""
        if self.domain_id in domains:
            try:
                lease = lease_domain(avoid=domains)
            except NoDomainFree:
                return
            self.close()
            self._use(lease)

    def __enter__(self) -> "Observer":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
