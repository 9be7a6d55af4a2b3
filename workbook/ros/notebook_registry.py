"""Register open notebooks, and list those on this machine with their domains.

Each open notebook's kernel holds an abstract Unix socket whose name contains all the data. Linux lists these names in
/proc/net/unix and removes a name when its process exits, so there are no stale entries.
"""

import os
import socket
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import quote, unquote

from workbook.inside import proc

SOCKET_PREFIX = "rclpy-workbook/kernel/"
_LONGEST_NAME = 100
"""The longest name, in characters. Linux allows 107 bytes after the zero byte of an abstract socket's name."""

_announced: socket.socket | None = None


@dataclass(frozen=True, order=True)
class OpenNotebook:
    """A running kernel: its notebook's name, its domain, and its process ID."""

    label: str
    domain_id: int
    pid: int


def notebook_label() -> str:
    """Return the name of this kernel's notebook, or "notebook" if Jupyter doesn't report it.

    An exercise's label begins with "exercise".
    """
    path = Path(os.environ.get("JPY_SESSION_NAME", ""))
    return f"exercise {path.stem}" if path.parent.name == "exercises" else path.stem or "notebook"


def announce(domain_id: int, label: str | None = None) -> None:
    """Register this process as an open notebook on `domain_id` until it exits. Do nothing if that's impossible."""
    global _announced
    withdraw()
    name = f"{SOCKET_PREFIX}{domain_id}/{os.getpid()}/{quote(label or notebook_label(), safe='')}"
    holder = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)  # never listens
    try:
        holder.bind("\0" + name[:_LONGEST_NAME])
    except OSError:
        holder.close()
        return
    _announced = holder


def withdraw() -> None:
    """Remove this process from the registry."""
    global _announced
    if _announced is not None:
        _announced.close()
        _announced = None


def _parse(name: str) -> OpenNotebook | None:
    parts = name.removeprefix("@" + SOCKET_PREFIX).split("/", 2)
    if len(parts) != 3 or not parts[0].isdigit() or not parts[1].isdigit():
        return None
    return OpenNotebook(unquote(parts[2]), int(parts[0]), int(parts[1]))


def _is_mine(pid: int) -> bool:
    return proc.owner(pid) == os.getuid()


def open_notebooks(table: str = proc.UNIX_SOCKETS) -> list[OpenNotebook]:
    """Return this user's open notebooks, sorted by name."""
    names = {name for name in proc.unix_socket_names(table) if f"@{SOCKET_PREFIX}" in name}
    found = [notebook for notebook in map(_parse, names) if notebook is not None]
    return sorted(notebook for notebook in found if _is_mine(notebook.pid))


def join_line(domain_id: int | None = None) -> str:
    """Return a shell command that joins a terminal to this notebook's domain. The terminal needs ROS 2."""
    domain = os.environ.get("ROS_DOMAIN_ID", "0") if domain_id is None else domain_id
    return f"export ROS_DOMAIN_ID={domain} ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST"
