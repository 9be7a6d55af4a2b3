"""Build bubblewrap's command lines for the outer and the inner sandbox, and test whether they work on this machine."""

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

Some of them have no size limit. Also, a process with root's user ID may write to files in /proc/sys, even without
capabilities. An answer has that ID if the judge runs as root.
"""
OUTER_ENVIRONMENT = {"TMPDIR": "/dev/shm", "XDG_CACHE_HOME": "/dev/shm/cache"}
WAITS = ("/bin/sh", "-c", "echo ready && exec >&- && while :; do sleep infinity & wait; done")
"""The command that an empty sandbox runs.

If the process that should read the "ready" was killed before the sandbox was tied to it, the `echo` fails and the shell
exits. Otherwise, the shell waits, and reaps the sandbox's processes when they exit.
"""
_SELF_TEST_S = 10.0


class NoSandbox(RuntimeError):
    """Raised when programs can't be sandboxed on this machine. The message says why, and what to do about it."""


def outer_command(command: Sequence[str], groups: Path | None = None) -> list[str]:
    """Return a command that runs `command` in an outer sandbox.

    The sandbox has its own network, read-only files, and its own /dev/shm.

    The process that calls this function must also start the command, because the command contains this process's ID.
    The sandbox's processes are killed as soon as this process exits or the thread that started the command finishes.
    `groups`: the folder for memory cgroups, or None if there are none. It's the only folder of the machine that
    `command` may write to. Raises NoSandbox if bubblewrap isn't installed.
    """
    return [
        *(sys.executable, "-I", "-S", str(RUN), "subreaper", str(os.getpid())),
        *_outer(command, groups),
    ]


def empty_outer_command(info_fd: int, groups: Path | None = None) -> list[str]:
    """Return a command for an empty outer sandbox.

    The sandbox prints "ready" and exists until its first process is killed. The command must run within another outer
    sandbox (see `outer_command`). `info_fd`: the descriptor to which bubblewrap writes the first process's ID. Raises
    NoSandbox if bubblewrap isn't installed.
    """
    return _outer(WAITS, groups, ("--info-fd", str(info_fd)))


def _outer(command: Sequence[str], groups: Path | None, options: Sequence[str] = ()) -> list[str]:
    """Return the command for an outer sandbox.

    The sandbox keeps the machine's /proc, because the kernel would otherwise refuse to mount a new /proc in the inner
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
    """Return a command that runs `command` in a sandbox for one program.

    Raises NoSandbox if bubblewrap isn't installed. `files`: descriptors of the files to copy to the answer's folder, by
    name. They're copied, because a mount would reveal the original path. `readable`: other files that the program may
    read, in addition to the system's files. `environ`: the program's complete environment. `options`: further
    bubblewrap options.

    /dev/full replaces /dev/zero. Both provide zeros, but a program could also get shared memory from /dev/zero, and
    that memory wouldn't be counted. The sandbox has no pseudoterminals, because all sandboxes would share one limit on
    their number.
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
    for folder in WRITABLE:  # before the mounts inside these folders
        sandboxed += ["--size", str(WRITABLE_BYTES), "--tmpfs", folder]
    sandboxed += system_files()
    for path in readable:
        sandboxed += ["--ro-bind", str(path), str(path)]
    for name, descriptor in files.items():
        sandboxed += ["--ro-bind-data", str(descriptor), f"{ANSWER_FOLDER}/{name}"]
    for name, value in environ.items():
        sandboxed += ["--setenv", name, value]
    for folder in READ_ONLY:  # after all mounts inside these folders
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
    """Return why programs can't be sandboxed on this machine and how to fix that, or None if they can.

    The first call tests whether a sandbox works.
    """
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
