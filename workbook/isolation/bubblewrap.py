"""The command lines of bubblewrap for the outer and the inner sandbox, and whether they work on this machine."""

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
"""Mounts of the sandbox itself. Two of them have no limit on their size, and files below /proc/sys obey whoever has the
user number of root, without any capability: an answer has it when the grader is root."""
OUTER_ENVIRONMENT = {"TMPDIR": "/dev/shm", "XDG_CACHE_HOME": "/dev/shm/cache"}
WAITS = ("/bin/sh", "-c", "echo ready && exec >&- && while :; do sleep infinity & wait; done")
"""If no reader is left for that word, it ends: who wanted it was killed before the sandbox was tied to it. While the
shell waits, it reaps all that has ended below it."""
_SELF_TEST_S = 10.0


class NoSandbox(RuntimeError):
    """Programs cannot be sandboxed on this machine. The message says why and what to do."""


def outer_command(command: Sequence[str], groups: Path | None = None) -> list[str]:
    """`command` in a network of its own, with the files of the machine read-only and a private /dev/shm.

    For children of this process: all ends with it, and with the thread that starts it. `groups`: the folder for memory
    cgroups, the one place of the machine that it may write to. Raises NoSandbox.
    """
    return [
        *(sys.executable, "-I", "-S", str(RUN), "subreaper", str(os.getpid())),
        *_outer(command, groups),
    ]


def empty_outer_command(info_fd: int, groups: Path | None = None) -> list[str]:
    """An outer sandbox for a process to enter: it says "ready", and stays until its first process is killed.

    `info_fd`: where bubblewrap tells which process that is. Within another outer sandbox, which see. Raises NoSandbox.
    """
    return _outer(WAITS, groups, ("--info-fd", str(info_fd)))


def _outer(command: Sequence[str], groups: Path | None, options: Sequence[str] = ()) -> list[str]:
    """/proc must stay that of the machine: the kernel refuses a fresh one in the inner sandbox otherwise."""
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
    """`command` in a sandbox for one program. Raises NoSandbox.

    `files`: descriptors of what is copied to the answer's folder, by name, because a mount would show where the
    original is; `readable`: what else it may read, besides the system's folders; `environ`: its whole environment;
    `options`: further options of bubblewrap. /dev/full reads as /dev/zero does, but gives no shared memory, which
    nothing would count. There are no terminals: all sandboxes would share their number.
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
    for folder in WRITABLE:  # before what is bound below them
        sandboxed += ["--size", str(WRITABLE_BYTES), "--tmpfs", folder]
    for folder in SYSTEM_FOLDERS:
        path = Path(folder)
        if path.is_symlink():
            sandboxed += ["--symlink", os.readlink(path), folder]
        elif path.is_dir():
            sandboxed += ["--ro-bind", folder, folder]
    for name in SYSTEM_FILES:
        sandboxed += ["--ro-bind-try", name, name]
    for path in readable:
        sandboxed += ["--ro-bind", str(path), str(path)]
    for name, descriptor in files.items():
        sandboxed += ["--ro-bind-data", str(descriptor), f"{ANSWER_FOLDER}/{name}"]
    for name, value in environ.items():
        sandboxed += ["--setenv", name, value]
    for folder in READ_ONLY:  # after everything that is bound below them
        sandboxed += ["--remount-ro", folder]
    return [*sandboxed, "--chdir", HOME, "--", *command]


@cache
def sandbox_problem() -> str | None:
    """Why programs cannot be sandboxed here, and what to do; None when they can. Tries it, once."""
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
