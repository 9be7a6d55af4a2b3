"""Domain leases: each domain has one holder, however the holder ends."""

import os
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest

from workbook.inside.proc import unix_socket_names
from workbook.ros import domains
from workbook.ros.domains import DomainLease, NoDomainFree, dds_port_range, domain_of_port, lease_domain
from workbook.ros.lease_holders import Holder

HOLDER = """
import sys
from workbook.ros.domains import lease_domain
lease = lease_domain(int(sys.argv[1]) if sys.argv[1:] else None)
print(lease.domain_id, flush=True)
sys.stdin.read()
"""


@pytest.fixture(autouse=True)
def _own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Put the markers of resting domains into a folder of this test."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))


@pytest.fixture
def held() -> Iterator[DomainLease]:
    with lease_domain() as lease:
        yield lease


@pytest.fixture
def all_leased(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[DomainLease]]:
    """Lease all domains, under names that no other process uses."""
    monkeypatch.setattr(domains, "SOCKET_PREFIX", f"test-{os.getpid()}/")
    monkeypatch.setattr(domains, "udp_ports_in_use", set)
    with ExitStack() as leases:
        yield [leases.enter_context(lease_domain()) for _ in range(101)]


def holder(*arguments: str) -> "subprocess.Popen[str]":
    return subprocess.Popen(
        [sys.executable, "-c", HOLDER, *arguments], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )


def domain_held_by(process: "subprocess.Popen[str]") -> int:
    assert process.stdout is not None
    return int(process.stdout.readline())


def test_a_lease_is_exclusive_within_a_process(held: DomainLease) -> None:
    assert 1 <= held.domain_id <= 101
    with lease_domain(preferred=held.domain_id) as other:
        assert other.domain_id != held.domain_id


def test_what_shall_be_avoided_is_taken_only_where_nothing_else_is() -> None:
    for _ in range(5):
        with lease_domain(avoid=range(1, 51)) as lease:
            assert lease.domain_id > 50
    with lease_domain(avoid=range(1, 102)) as lease:
        assert 1 <= lease.domain_id <= 101


def test_a_released_domain_can_be_had_again(held: DomainLease) -> None:
    held.release()
    held.release()
    with lease_domain(preferred=held.domain_id) as again:
        assert again.domain_id == held.domain_id


def test_a_lease_is_exclusive_between_processes(held: DomainLease) -> None:
    with holder(str(held.domain_id)) as other:
        assert domain_held_by(other) != held.domain_id
        other.kill()


def test_a_lease_dies_with_its_holder() -> None:
    with holder() as other:
        domain_id = domain_held_by(other)
        assert domains._try_lease(domain_id) is None
        other.kill()
        other.wait()
        lease = domains._try_lease(domain_id)
        assert lease is not None
        lease.release()


def test_a_child_does_not_inherit_the_lease(held: DomainLease) -> None:
    """A program that outlives its observer must not hold the domain."""
    with subprocess.Popen(
        [sys.executable, "-c", "import sys; print('up', flush=True); sys.stdin.read()"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        close_fds=False,
        text=True,
    ) as child:
        assert child.stdout is not None
        assert child.stdout.readline() == "up\n"
        held.release()
        again = domains._try_lease(held.domain_id)
        assert again is not None
        again.release()
        child.kill()


def test_a_domain_rests_after_a_kill(monkeypatch: pytest.MonkeyPatch) -> None:
    lease = lease_domain()
    domain_id = lease.domain_id
    lease.release(killed=True)
    now = domains.time.time()
    for later, free in ((1.0, False), (29.0, False), (31.0, True)):
        monkeypatch.setattr(domains.time, "time", lambda later=later: now + later)
        with lease_domain(preferred=domain_id) as next_one:
            assert (next_one.domain_id == domain_id) is free, later


def test_a_rest_in_the_future_is_no_rest(monkeypatch: pytest.MonkeyPatch) -> None:
    """As after the clock was set back by a day."""
    lease = lease_domain()
    lease.release(killed=True)
    yesterday = domains.time.time() - 86_400
    monkeypatch.setattr(domains.time, "time", lambda: yesterday)
    with lease_domain(preferred=lease.domain_id) as again:
        assert again.domain_id == lease.domain_id


def test_a_cache_that_cannot_be_written_only_costs_the_rest(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    lease = lease_domain()
    lease.release(killed=True)
    with lease_domain(preferred=lease.domain_id) as again:
        assert again.domain_id == lease.domain_id


@pytest.mark.parametrize("kind", [socket.SOCK_DGRAM, socket.SOCK_STREAM, socket.SOCK_SEQPACKET])
def test_nothing_can_be_sent_to_what_holds_a_lease(
    kind: socket.SocketKind, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A message would stay in the socket for the whole lease, and the next process would receive it."""
    monkeypatch.setattr(domains, "SOCKET_PREFIX", prefix := f"test-{os.getpid()}/")
    with lease_domain() as lease, socket.socket(socket.AF_UNIX, kind) as sender:
        announced = [name for name in unix_socket_names() if f"/{lease.domain_id}/{os.getpid()}/" in name]
        assert announced
        for name in (f"@{prefix}{lease.domain_id}", *announced):
            with pytest.raises(OSError, match=r"refused|wrong type"):
                sender.connect("\0" + name[1:])


def test_a_lease_in_a_network_of_ones_own_tells_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    before = unix_socket_names()
    monkeypatch.setattr(domains, "_private_prefix", None)
    domains.lease_in_private()
    with lease_domain() as lease:
        added = [name for name in unix_socket_names() - before if name.endswith(str(lease.domain_id))]
        assert len(added) == 1
        assert "rclpy" not in added[0] and str(os.getpid()) not in added[0]
        with lease_domain(preferred=lease.domain_id) as other:
            assert other.domain_id != lease.domain_id


def test_a_domain_whose_ports_a_stranger_holds_is_skipped(held: DomainLease) -> None:
    held.release()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
        stranger.bind(("127.0.0.1", dds_port_range(held.domain_id)[11]))
        with lease_domain(preferred=held.domain_id) as other:
            assert other.domain_id != held.domain_id
    with lease_domain(preferred=held.domain_id) as again:
        assert again.domain_id == held.domain_id


def test_none_free_says_what_to_do(all_leased: list[DomainLease], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(domains, "lease_holders", lambda: [Holder(7, os.getuid(), os.getppid())])
    with pytest.raises(NoDomainFree, match=rf"1 domain by you \(process {os.getppid()}\).*Close notebooks"):
        lease_domain()
    monkeypatch.setattr(domains, "lease_holders", list)
    with pytest.raises(NoDomainFree, match=r"is free.*try again"):
        lease_domain()


def test_domains_that_rest_or_belong_to_strangers_are_counted(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(domains, "SOCKET_PREFIX", f"test-{os.getpid()}/")
    monkeypatch.setattr(domains, "udp_ports_in_use", set)
    for domain_id in range(1, 91):
        lease_domain(preferred=domain_id).release(killed=True)
    monkeypatch.setattr(domains, "lease_holders", list)
    monkeypatch.setattr(domains, "udp_ports_in_use", lambda: {*range(7400, 33_000, 10)})
    with pytest.raises(NoDomainFree) as raised:
        lease_domain()
    assert "On hold for up to 30 s, because a program was killed: 90." in str(raised.value)
    assert "Used by ROS programs that lease none: 11" in str(raised.value)


def test_every_domain_can_be_leased_once(all_leased: list[DomainLease]) -> None:
    assert {lease.domain_id for lease in all_leased} == set(range(1, 102))
    with pytest.raises(NoDomainFree):
        lease_domain()


def test_ports_and_domains_belong_together() -> None:
    for domain_id in (0, 1, 101, 232):
        ports = dds_port_range(domain_id)
        assert {domain_of_port(ports[0]), domain_of_port(ports[-1])} == {domain_id}
    assert domain_of_port(7399) is None
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as mine:
        mine.bind(("127.0.0.1", 0))
        assert mine.getsockname()[1] in domains.udp_ports_in_use()
    assert domains.udp_ports_in_use(["/no/such/table"]) == set()
