"""A place to watch programs from: a leased domain, on which they run one after another."""

from collections.abc import Container

from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.programs.tier import Tier
from workbook.recording.plan import Plan
from workbook.recording.recording import Clock
from workbook.ros.domains import DomainLease, NoDomainFree, lease_domain
from workbook.ros.environment import is_prepared, prepare
from workbook.watching.recorder import OnTake
from workbook.watching.watch import Watch


class Observer:
    """Holds one leased domain and watches programs, one after another, in a `tier` of isolation or in none.

    Keep one per slot: a warm observer saves the start of a context. After a program had to be killed it moves to
    another domain, because the nodes of a killed program stay on the graph for a while. `on_take`: what is told
    whenever messages were taken.
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
        """The leased ROS domain. Not to be used after `close`."""
        assert self._lease is not None, "this observer is closed"
        return self._lease.domain_id

    def close(self) -> None:
        """Give the domain back."""
        if self._lease is not None:
            self._lease.release()
            self._lease = None

    def move(self) -> None:
        """Lease another domain, and let this one cool down: killed programs stay on its graph for a while."""
        if self._lease is not None:
            self._lease.release(killed=True)
        self._use(lease_domain())

    def keep_off(self, domains: Container[int]) -> None:
        """Move to another domain, if there is a free one, when this is one of `domains`."""
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

    def watch(self, spec: ProgramSpec, plan: Plan, clock: Clock, process: NodeProcess | None = None) -> Watch:
        """Start a program and return the running watch; use it as a context manager.

        `process`: the program, if it runs on this domain already. Raises OSError when it cannot be started.
        """
        return Watch(self, spec, plan, clock, process)
