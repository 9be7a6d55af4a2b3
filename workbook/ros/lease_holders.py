"""Find the holders of leases on ROS domains. We ask Linux where possible, so that a process can't blame another.

A holder announces its process ID and the lease's start time in the name of a second abstract Unix socket. Linux reports
each socket's user, even without an announcement, and an announced process counts only if it belongs to that user.
"""

import os
import pwd
import socket
import struct
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from workbook.inside import proc

LEASE_PREFIX = "rclpy-workbook/domain/"
HOLDER_PREFIX = "rclpy-workbook/holder/"
MOST_NAMED = 4
LONGEST_COMMAND = 60
LONGEST_TIME = 86_400 * 365 * 100
"""The largest valid time in an announcement, as a Unix timestamp in seconds."""

NETLINK_SOCK_DIAG, SOCK_DIAG_BY_FAMILY, NLM_F_DUMP_REQUEST = 4, 20, 0x301
NLMSG_ERROR, NLMSG_DONE = 2, 3
UDIAG_SHOW_NAME, UDIAG_SHOW_UID = 1, 0x40
UNIX_DIAG_NAME, UNIX_DIAG_UID = 0, 7
_ALL_STATES = 0xFFFFFFFF
_PATIENCE_S = 2.0


@dataclass(frozen=True, order=True)
class Holder:
    """The holder of a domain's lease. Unknown values are None or "".

    `since`: the start of the lease, as a Unix timestamp in seconds.
    """

    domain_id: int
    user: int | None
    pid: int | None = None
    since: float | None = None
    command: str = ""


def announce_lease(domain_id: int) -> socket.socket | None:
    """Announce that this process holds a domain. The announcement lasts until the returned socket is closed.

    Return None if the announcement is impossible.
    """
    announced = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)  # never listens
    try:
        announced.bind(f"\0{HOLDER_PREFIX}{domain_id}/{os.getpid()}/{int(time.time())}")
    except OSError:
        announced.close()
        return None
    return announced


def lease_holders() -> list[Holder]:
    """Return the current holders of this machine's domains, sorted by domain."""
    named = _abstract_sockets()
    owners = dict(_leases(named))
    holders = {domain_id: Holder(domain_id, user) for domain_id, user in owners.items()}
    for name, user in named:
        numbers = name.removeprefix(HOLDER_PREFIX).split("/")
        if not name.startswith(HOLDER_PREFIX) or len(numbers) != 3 or not all(map(_is_number, numbers)):
            continue
        domain_id, pid, since = map(int, numbers)
        claimed = proc.owner(pid)
        if domain_id not in owners or claimed is None or since > LONGEST_TIME:
            continue
        if user in (None, claimed) and owners[domain_id] in (None, claimed):
            holders[domain_id] = Holder(domain_id, claimed, pid, float(since), _command(pid))
    return sorted(holders.values(), key=lambda holder: holder.domain_id)


def who_holds_them(holders: Sequence[Holder], own: int | None = None) -> str:
    """Return sentences that name leases' holders and say what to do. `own`: the reader's user ID (default: ours)."""
    own = os.getuid() if own is None else own
    groups = Counter((one.user, one.pid, one.command) for one in holders)
    since = {(one.user, one.pid, one.command): one.since for one in reversed(holders)}
    lines = [
        _line(number, *group, since[group], mine=group[0] == own)
        for group, number in groups.most_common(MOST_NAMED)
    ]
    rest = len(groups) - len(lines)
    if rest:
        lines.append(f"and {rest} more")
    mine = [
        pid for (user, pid, _), _ in groups.most_common() if user == own and pid not in (None, os.getpid())
    ]
    others = {_user(user) for user, _, _ in groups if user not in (own, None)}
    advice = []
    if mine:
        numbers = " ".join(map(str, mine[:MOST_NAMED]))
        advice.append(f"close notebooks and end grading runs that you don't need (`kill {numbers}`)")
    if others:
        advice.append(f"ask {_listed(sorted(others))}, or the administrator of this machine, to end theirs")
    if not advice:
        advice.append("close some of them")
    return f"Leased: {'; '.join(lines)}. {_sentence(', or '.join(advice))}; then try again."


def _line(
    number: int, user: int | None, pid: int | None, command: str, since: float | None, *, mine: bool
) -> str:
    what = "1 domain" if number == 1 else f"{number} domains"
    who = "you" if mine else _user(user)
    details = [] if pid is None else [f"process {pid}"]
    if command:
        details.append(f"`{command}`")
    if since is not None:
        details.append(f"since {time.strftime('%Y-%m-%d %H:%M', time.localtime(since))}")
    return f"{what} by {who}" + (f" ({', '.join(details)})" if details else "")


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:]


def _listed(names: Sequence[str]) -> str:
    more = len(names) - MOST_NAMED
    return ", ".join(names[:MOST_NAMED]) + (f" and {more} others" if more > 0 else "")


def _user(user: int | None) -> str:
    if user is None:
        return "somebody"
    try:
        return pwd.getpwuid(user).pw_name
    except KeyError:
        return f"user {user}"


def _command(pid: int) -> str:
    """Return the start of a process's command line, without control characters, because it's untrusted."""
    said = proc.command_line(pid).replace(b"\0", b" ").decode(errors="replace").replace("`", "'")
    text = " ".join("".join(one if one.isprintable() else " " for one in said).split())
    return text if len(text) <= LONGEST_COMMAND else f"{text[: LONGEST_COMMAND - 1]}…"


def _is_number(text: str) -> bool:
    return text.isascii() and text.isdecimal() and len(text) < 12


def _leases(named: Sequence[tuple[str, int | None]]) -> Iterator[tuple[int, int | None]]:
    for name, user in named:
        number = name.removeprefix(LEASE_PREFIX)
        if name.startswith(LEASE_PREFIX) and _is_number(number):
            yield int(number), user


def _abstract_sockets() -> list[tuple[str, int | None]]:
    """Return the name and user of each abstract socket on this machine whose name has one of our prefixes."""
    try:
        found = [*_asked_of_the_kernel()]
    except (OSError, struct.error):
        found = [(name[1:], None) for name in proc.unix_socket_names() if name.startswith("@")]
    return [one for one in found if one[0].startswith((LEASE_PREFIX, HOLDER_PREFIX))]


def _asked_of_the_kernel() -> Iterator[tuple[str, int | None]]:
    """Ask Linux for all abstract sockets, and yield each one's name and user. Raises OSError if Linux refuses.

    The user is None before Linux 5.3. See sock_diag(7).
    """
    request = struct.pack(
        "=BBHIIIQ", socket.AF_UNIX, 0, 0, _ALL_STATES, 0, UDIAG_SHOW_NAME | UDIAG_SHOW_UID, 0
    )
    header = struct.pack("=IHHII", 16 + len(request), SOCK_DIAG_BY_FAMILY, NLM_F_DUMP_REQUEST, 1, 0)
    with socket.socket(socket.AF_NETLINK, socket.SOCK_DGRAM, NETLINK_SOCK_DIAG) as kernel:
        kernel.settimeout(_PATIENCE_S)
        kernel.send(header + request)
        while True:
            data = kernel.recv(1 << 18)
            while data:
                length, kind, _, _, _ = struct.unpack_from("=IHHII", data)
                if kind == NLMSG_DONE:
                    return
                if kind == NLMSG_ERROR or length < 16:
                    raise OSError("the kernel gives no information about its sockets")
                attributes = _attributes(data[32:length])
                name, user = attributes.get(UNIX_DIAG_NAME, b""), attributes.get(UNIX_DIAG_UID)
                if name[:1] == b"\0":
                    yield (
                        name[1:].decode(errors="replace"),
                        None if user is None else struct.unpack("=I", user)[0],
                    )
                data = data[(length + 3) & ~3 :]


def _attributes(data: bytes) -> dict[int, bytes]:
    found: dict[int, bytes] = {}
    while len(data) >= 4:
        length, kind = struct.unpack_from("=HH", data)
        found[kind] = data[4:length]
        data = data[max(4, (length + 3) & ~3) :]
    return found
