"""Build bubblewrap's command lines for the outer and the inner sandbox, and test whether they work here."""

import os
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path

from workbook.inside import RUN
from workbook.isolation.host_files import SYSTEM_FILES, SYSTEM_FOLDERS
from workbook.recording.limits import WRITABLE_MIB

HOME = "/home/student"
ANSWER_FOLDER = "/answer"
WRITABLE = ("/tmp", "/dev/shm", HOME)
WRITABLE_BYTES = WRITABLE_MIB * 1024 * 1024
READ_ONLY = ("/", "/dev", "/dev/pts", "/proc")
"""The mounts that bubblewrap itself creates, which must be made read-only.

Two of them have no size limit. Also, a process with root's user ID may write to files in /proc/sys, even without
capabilities. An answer has that ID if the judge runs as root.
"""
OUTER_ENVIRONMENT = {"TMPDIR": "/dev/shm", "XDG_CACHE_HOME": "/dev/shm/cache"}
WAITS = ("/bin/sh", "-c", "echo ready && exec >&- && while :; do sleep infinity & wait; done")
"""The command that an empty sandbox runs.

The shell exits if no process reads its "ready", because the reader was killed before the sandbox was tied to it. While
the shell waits, it reaps the sandbox's processes that end.
"""
_SELF_TEST_S = 10.0


class NoSandbox(RuntimeError):
    """Programs can't be sandboxed on this machine. The message says why, and what to do about it."""


def outer_command(command: Sequence[str], groups: Path | None = None) -> list[str]:
    """Return a command that runs `command` with a separate network, read-only files, and a private /dev/shm.

    This process itself must start the command, because the sandbox ends as soon as this process or the thread that
    started it ends. `groups`: the folder for memory cgroups, which is the only folder of the machine that `command` may
    write to; None if there are none. Raises NoSandbox.
    """
    return [
        *(sys.executable, "-I", "-S", str(RUN), "subreaper", str(os.getpid())),
        *_outer(command, groups),
    ]


def empty_outer_command(info_fd: int, groups: Path | None = None) -> list[str]:
    """Return a command for an empty outer sandbox. It prints "ready", and stays until its first process is killed.

    The command must run within another outer sandbox (see `outer_command`). `info_fd`: the descriptor to which
    bubblewrap writes the first process's ID. Raises NoSandbox.
    """
    return _outer(WAITS, groups, ("--info-fd", str(info_fd)))


def _outer(command: Sequence[str], groups: Path | None, options: Sequence[str] = ()) -> list[str]:
    """Return the command for an outer sandbox.

    The sandbox keeps the machine's /proc, because otherwise, the kernel refuses to mount a new one in the inner
    sandbox.
    """
    writable = [] if groups is None else ["--bind", str(groups), str(groups)]
    setting = [word for name, value in OUTER_ENVIRONMENT.items() for word in ("--setenv", name, value)]
    return [
        _bwrap(),
        *("--unshare-user", "--unshare-net", "--unshare-ipc", "--die-with-parent"),
        *options,
        *("--ro-bind", "/", "/", "--bind", "/proc", "/proc", "--dev-bind", "/dev", "/dev"),
        *writable,
        *("--tmpfs", "/dev/shm", "--tmpfs", "/run"),
        *setting,
        "--",
        *command,
    ]


def inner_command(
    command: Sequence[str],
    *,
    files: Mapping[str, int],
    readable: Sequence[Path],
    environ: Mapping[str, str],
    options: Sequence[str],
) -> list[str]:
    """Return a command that runs `command` in a sandbox for one program. Raises NoSandbox.

    `files`: descriptors of the files to copy to the answer's folder, by name. They're copied, because a mount would
    reveal the original path. `readable`: other files that the program may read, in addition to the system's files.
    `environ`: the program's complete environment. `options`: further bubblewrap options.

    /dev/full replaces /dev/zero: reading it gives the same zeros, but it provides no shared memory, which wouldn't be
    counted. There are no terminals, because all sandboxes would share one limit on their number.
    """
    sandboxed = [
        _bwrap(),
        *("--unshare-user", "--unshare-pid", "--unshare-ipc", "--unshare-uts", "--unshare-cgroup-try"),
        *("--die-with-parent", "--new-session", "--cap-drop", "ALL", "--clearenv", "--hostname", "robot"),
        "--disable-userns",
        *options,
        *("--proc", "/proc", "--dev", "/dev", "--dev-bind", "/dev/full", "/dev/zero"),
        *("--tmpfs", "/dev/pts"),
    ]
    for folder in WRITABLE:  # before the mounts below them
        sandboxed += ["--size", str(WRITABLE_BYTES), "--tmpfs", folder]
    sandboxed += system_files()
    for path in readable:
        sandboxed += ["--ro-bind", str(path), str(path)]
    for name, descriptor in files.items():
        sandboxed += ["--ro-bind-data", str(descriptor), f"{ANSWER_FOLDER}/{name}"]
    for name, value in environ.items():
        sandboxed += ["--setenv", name, value]
    for folder in READ_ONLY:  # after all mounts below them
        sandboxed += ["--remount-ro", folder]
    return [*sandboxed, "--chdir", HOME, "--", *command]


def system_files() -> list[str]:
    """Return bubblewrap options that mount the system files that every program needs, read-only."""
    options = []
    for folder in SYSTEM_FOLDERS:
        path = Path(folder)
        if path.is_symlink():
            options += ["--symlink", os.readlink(path), folder]
        elif path.is_dir():
            options += ["--ro-bind", folder, folder]
    for name in SYSTEM_FILES:
        options += ["--ro-bind-try", name, name]
    return options


@cache
def sandbox_problem() -> str | None:
    """Return why programs can't be sandboxed here, and how to fix it; None if they can. The first call tries it."""
    if shutil.which("bwrap") is None:
        return "bubblewrap is not installed (apt install bubblewrap)"
    read_fd, write_fd = os.pipe()
    info = ("--info-fd", str(write_fd))
    try:
        inner = inner_command(["/bin/true"], files={}, readable=(), environ={}, options=info)
        done = subprocess.run(
            outer_command(inner), capture_output=True, text=True, timeout=_SELF_TEST_S, pass_fds=[write_fd]
        )
    except subprocess.TimeoutExpired:
        return "bubblewrap does not finish"
    finally:
        os.close(read_fd)
        os.close(write_fd)
    if done.returncode == 0:
        return None
    said = done.stderr.strip()[:160] or f"exit code {done.returncode}"
    if "uid map" in said or "Permission denied" in said or "No permissions" in said:
        return (
            f"this kernel keeps programs out of user namespaces ({said}). On Ubuntu 24.04: sudo sysctl -w "
            "kernel.apparmor_restrict_unprivileged_userns=0; in Docker: --security-opt seccomp=unconfined"
        )
    return f"bubblewrap is there but may not isolate: {said}"


def _bwrap() -> str:
    found = shutil.which("bwrap")
    if found is None:
        raise NoSandbox("bubblewrap is not installed (apt install bubblewrap)")
    return found
