"""Lease ROS domains, so that no two processes lease the same one.

A lease is an abstract Unix socket named after the domain. Linux closes the socket when the process exits or is killed,
so no lease is left behind. It's a stream socket that never listens, so other processes can't fill its buffer with data.
Domains 1 to 101 avoid Linux's ephemeral ports (UDP port = 7400 + 250 * domain + …, DDS-RTPS specification, section
9.6.1).
"""

import os
import random
import socket
import time
from collections.abc import Container
from pathlib import Path
from types import TracebackType

from workbook.inside.proc import udp_ports_in_use
from workbook.ros.lease_holders import LEASE_PREFIX, announce_lease, lease_holders, who_holds_them

FIRST_DOMAIN = 1
"""Domain 0 is ROS's default, so a robot or a student's own terminal may be using it."""
LAST_DOMAIN = 101
"""Domain 102's ports begin at 32900, which is in Linux's ephemeral range (from 32768)."""
COOL_DOWN_S = 30.0
"""How long (s) a domain isn't leased again after one of its programs was killed.

This is much longer than the DDS liveliness lease, after which other participants forget a participant that vanished.
"""
SOCKET_PREFIX = LEASE_PREFIX
_private_prefix: str | None = None


class NoDomainFree(RuntimeError):
    """Raised when every domain from 1 to 101 is in use or cooling down."""


def dds_port_range(domain_id: int) -> range:
    """Return the UDP ports that the participants in a domain may use."""
    start = 7400 + 250 * domain_id
    return range(start, start + 250)


def domain_of_port(port: int) -> int | None:
    """Return the ROS domain that a UDP port belongs to, or None if it isn't a DDS port."""
    domain_id = (port - 7400) // 250
    return domain_id if port >= 7400 and domain_id <= 232 else None


def _cool_down_folder() -> Path:
    cache = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    return Path(cache) / "rclpy-workbook" / "resting"


def _is_cooling_down(domain_id: int) -> bool:
    marker = _cool_down_folder() / str(domain_id)
    try:
        age = time.time() - marker.stat().st_mtime
    except OSError:
        return False
    if 0 <= age < COOL_DOWN_S:
        return True
    marker.unlink(missing_ok=True)
    return False


def _begin_cool_down(domain_id: int) -> None:
    try:
        folder = _cool_down_folder()
        folder.mkdir(parents=True, exist_ok=True)
        (folder / str(domain_id)).touch()
    except OSError:
        # the cache isn't writable, so the domain is free right away, although its stale participant expires only after
        # 2 s
        pass


class DomainLease:
    """A ROS domain that belongs to this process until it calls `release` or exits."""

    def __init__(self, domain_id: int, holder: socket.socket) -> None:
        self.domain_id = domain_id
        self._holder: socket.socket | None = holder
        self._announced = announce_lease(domain_id) if _private_prefix is None else None

    def release(self, killed: bool = False) -> None:
        """Release the domain.

        `killed`: whether a program on the domain was killed. Such a program couldn't announce its departure, so other
        programs would still discover its stale participant. That's why the domain isn't leased again for 30 s.
        """
        if self._holder is None:
            return
        if killed:
            _begin_cool_down(self.domain_id)
        if self._announced is not None:
            self._announced.close()
        self._holder.close()
        self._holder = None

    def __enter__(self) -> "DomainLease":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.release()


def lease_in_private() -> None:
    """Use random names for this process's leases, because untrusted programs can see the names.

    Call this only in a process with its own network, whose domains can't clash with another process's.
    """
    global _private_prefix
    _private_prefix = os.urandom(8).hex()


def _try_lease(domain_id: int) -> DomainLease | None:
    holder = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    try:
        holder.bind(f"\0{SOCKET_PREFIX if _private_prefix is None else _private_prefix}{domain_id}")
    except OSError:
        holder.close()
        return None
    return DomainLease(domain_id, holder)


def lease_domain(preferred: int | None = None, avoid: Container[int] = ()) -> DomainLease:
    """Lease a free domain from 1 to 101: `preferred` if it's free, and one in `avoid` only if no other domain is free.

    Skip domains that another process holds, that are cooling down after a kill, or whose ports another process uses.
    Raise NoDomainFree if no domain is left.
    """
    candidates = list(range(FIRST_DOMAIN, LAST_DOMAIN + 1))
    random.shuffle(candidates)
    candidates.sort(key=lambda domain_id: domain_id in avoid)
    if preferred is not None:
        candidates.insert(0, preferred)
    ports = udp_ports_in_use()
    for domain_id in candidates:
        if _is_cooling_down(domain_id) or not ports.isdisjoint(dds_port_range(domain_id)):
            continue
        lease = _try_lease(domain_id)
        if lease is not None:
            return lease
    raise NoDomainFree(_why_none_is_free(ports))


def _why_none_is_free(ports: set[int]) -> str:
    """Return sentences that name the processes that hold the domains, and say what to do."""
    holders = lease_holders()
    free = set(range(FIRST_DOMAIN, LAST_DOMAIN + 1)) - {holder.domain_id for holder in holders}
    resting = {domain_id for domain_id in free if _is_cooling_down(domain_id)}
    strangers = {one for one in free - resting if not ports.isdisjoint(dds_port_range(one))}
    sentences = [f"No ROS domain from {FIRST_DOMAIN} to {LAST_DOMAIN} is free."]
    if resting:
        sentences.append(
            f"On hold for up to {COOL_DOWN_S:.0f} s, because a program was killed: {len(resting)}."
        )
    if strangers:
        sentences.append(f"Used by ROS programs that lease none: {len(strangers)} (`ss -lupn` lists them).")
    sentences.append(who_holds_them(holders) if holders else "Wait a moment, and try again.")
    return " ".join(sentences)
