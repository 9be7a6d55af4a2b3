"""Report who holds a domain: user, process, time, and command. No process can put the blame on another."""

import os
import re
import socket
import subprocess
import sys
import time
from typing import Any

import pytest

from workbook.ros import lease_holders as module
from workbook.ros.domains import lease_domain
from workbook.ros.lease_holders import HOLDER_PREFIX, LEASE_PREFIX, Holder, lease_holders, who_holds_them

ME = os.getuid()
NOBODY = 65_534
HOLDS = """
import sys
from workbook.ros.domains import lease_domain
with lease_domain() as lease:
    print(lease.domain_id, flush=True)
    sys.stdin.read()
"""
BINDS = """
import socket, sys
for name in sys.argv[1:]:
    one = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    one.bind(chr(0) + name)
    globals()[name] = one
print("bound", flush=True)
sys.stdin.read()
"""


def holder_of(domain_id: int) -> Holder | None:
    return next((one for one in lease_holders() if one.domain_id == domain_id), None)


def bound(*names: str, user: int | None = None) -> "subprocess.Popen[str]":
    """Start a process that holds these abstract sockets."""
    command = ["/usr/bin/env", "python3", "-I", "-S", "-c", BINDS, *names]
    pipe = subprocess.PIPE
    process = subprocess.Popen(command, stdin=pipe, stdout=pipe, text=True, user=user, cwd="/")
    assert process.stdout is not None and process.stdout.readline() == "bound\n"
    return process


@pytest.fixture
def own_names(monkeypatch: pytest.MonkeyPatch) -> str:
    """Use names that no other lease on this machine has, so that other processes aren't disturbed."""
    prefix = f"test-{os.getpid()}/"
    monkeypatch.setattr(module, "LEASE_PREFIX", prefix + LEASE_PREFIX)
    monkeypatch.setattr(module, "HOLDER_PREFIX", prefix + HOLDER_PREFIX)
    return prefix


class WithoutNetlink(socket.socket):
    """A socket class for a sandbox or an old kernel that refuses Netlink queries."""

    def __init__(self, family: int = -1, *others: int, **more: Any) -> None:
        if family == socket.AF_NETLINK:
            raise PermissionError
        super().__init__(family, *others, **more)


@pytest.mark.parametrize("kernel_tells", [True, False])
def test_a_lease_tells_its_process_user_moment_and_command(
    kernel_tells: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    if not kernel_tells:
        monkeypatch.setattr(module.socket, "socket", WithoutNetlink)
    before = int(time.time())
    with subprocess.Popen(
        [sys.executable, "-c", HOLDS], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        holder = holder_of(int(process.stdout.readline()))
        assert holder is not None
        assert (holder.user, holder.pid) == (ME, process.pid)
        assert holder.since is not None and before <= holder.since <= time.time()
        assert sys.executable in holder.command and "import sys" in holder.command
        process.kill()


def test_a_lease_that_was_given_back_has_no_holder() -> None:
    with lease_domain() as lease:
        found = holder_of(lease.domain_id)
        assert found is not None and found.pid == os.getpid()
    found = holder_of(lease.domain_id)
    assert found is None or found.pid != os.getpid()


def test_who_announces_nothing_is_known_by_the_user(own_names: str) -> None:
    user = NOBODY if ME == 0 else ME
    with bound(f"{own_names}{LEASE_PREFIX}7", user=user if ME == 0 else None) as process:
        assert lease_holders() == [Holder(7, user)]
        process.kill()


def test_nobody_puts_the_blame_on_another_users_process(own_names: str) -> None:
    if ME != 0:  # only root can act as two users
        return
    lease, blames = f"{own_names}{LEASE_PREFIX}7", f"{own_names}{HOLDER_PREFIX}7/{os.getpid()}/1"
    with bound(lease, blames, user=NOBODY) as stranger:
        assert lease_holders() == [Holder(7, NOBODY)]
        stranger.kill()
    with bound(lease) as mine, bound(blames, user=NOBODY) as stranger:
        assert lease_holders() == [Holder(7, 0)]
        mine.kill()
        stranger.kill()


@pytest.mark.parametrize("odd", ["7", "7/1", "7/1/x", "7/1/99999999999", "x/1/1", "7/²/1", "7//1", "8/1/1"])
def test_an_odd_announcement_counts_for_nothing(odd: str, own_names: str) -> None:
    with bound(f"{own_names}{LEASE_PREFIX}7", f"{own_names}{HOLDER_PREFIX}{odd}") as process:
        assert lease_holders() == [Holder(7, ME)]
        process.kill()


def test_holders_are_named_by_how_much_they_hold_and_what_to_do_is_said() -> None:
    hog = [Holder(number, NOBODY, 4711, 1.0e9, "python hog.py") for number in range(1, 91)]
    mine = [Holder(number, ME, 12, 1.7e9, "python -m ipykernel") for number in range(91, 101)]
    said = who_holds_them([*hog, *mine, Holder(101, None)])
    assert re.search(r"^Leased: 90 domains by \w+ \(process 4711, `python hog\.py`, since 2001-09-0\d", said)
    assert "; 10 domains by you (process 12, `python -m ipykernel`, since 20" in said
    assert "; 1 domain by somebody. Close notebooks" in said
    assert "(`kill 12`), or ask " in said and said.endswith("; then try again.")


def test_many_holders_are_counted() -> None:
    said = who_holds_them([Holder(number, 100_000 + number, number) for number in range(1, 102)])
    assert said.count("process") == module.MOST_NAMED and f"and {101 - module.MOST_NAMED} more" in said
    assert len(said) < 600


def test_a_command_is_no_command_to_the_terminal() -> None:
    line = "import sys; print('up', flush=True); sys.stdin.read()"
    odd = "\x1b[2J`reboot`\u202e" + "x" * 200
    with subprocess.Popen(
        [sys.executable, "-c", line, odd], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as process:
        assert process.stdout is not None and process.stdout.readline() == b"up\n"
        said = module._command(process.pid)
        process.kill()
    assert said.isprintable() and "`" not in said and len(said) <= module.LONGEST_COMMAND
    assert module._command(2**22 + 1) == ""
