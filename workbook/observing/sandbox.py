"""Shutting a stranger's program in: bubblewrap in bubblewrap.

The outer box holds the observer and gives it a network of its own. The inner box holds one answer: the same network
and nothing else; no capabilities, no other processes, no files but the interpreter and the answer itself, read-only,
and small folders in memory to write to.
"""

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from workbook.observing.warm_start import ForkServer

HOME = "/home/student"
ANSWER_FOLDER = "/answer"
WRITABLE_BYTES = 64 * 1024 * 1024
SYSTEM_FOLDERS = ("/usr", "/lib", "/lib64", "/bin", "/sbin")
SYSTEM_FILES = ("/etc/ld.so.cache", "/etc/localtime", "/etc/alternatives")
READ_ONLY = ("/", "/dev", "/proc")
"""Mounts of the box itself. Two of them have no limit on their size, and files below /proc/sys obey whoever has the
user number of root, without any capability: an answer has it when the grader is root."""
NOT_FOR_ANSWERS = ("WORKBOOK_RUN", "XDG_CACHE_HOME")
"""Variables of the bench that would tell a program that it is being judged."""
_PACKAGE = Path(__file__).resolve().parents[1]
KEEPER = Path(__file__).with_name("keeper.py")
_SELF_TEST_S = 10.0


class NoSandbox(RuntimeError):
    """Programs cannot be shut in on this machine. The message says why and what to do."""


def outer_command(command: Sequence[str]) -> list[str]:
    """`command` in a network of its own, with the files of the machine read-only and a private /dev/shm.

    For children of this process: all ends with it, and with the thread that starts it.

    /proc must stay that of the machine: the kernel refuses a fresh one in the inner box otherwise.
    """
    return [
        *(sys.executable, "-I", "-S", str(KEEPER), str(os.getpid())),
        _bwrap(),
        *("--unshare-user", "--unshare-net", "--unshare-ipc", "--die-with-parent"),
        *("--ro-bind", "/", "/", "--bind", "/proc", "/proc", "--dev-bind", "/dev", "/dev"),
        *("--tmpfs", "/dev/shm", "--tmpfs", "/run", "--setenv", "TMPDIR", "/dev/shm"),
        *("--setenv", "XDG_CACHE_HOME", "/dev/shm/cache"),
        "--",
        *command,
    ]


@dataclass(frozen=True)
class Cage:
    """The inner box. `readable`: what else a program may read (the interpreter and the host are always there).

    With a `server`, programs are forked from it into their boxes, which saves the start of a Python for each.
    """

    readable: tuple[Path, ...] = field(default_factory=lambda: interpreter_folders())
    server: ForkServer | None = None

    def environment(self, environ: Mapping[str, str]) -> dict[str, str]:
        """What a program in the box finds in its environment."""
        inside = {**environ, "HOME": HOME, "PWD": HOME, "PATH": "/usr/bin:/bin"}
        inside |= {"TMPDIR": "/tmp", "ROS_LOG_DIR": "/tmp"}
        return {name: value for name, value in inside.items() if name not in NOT_FOR_ANSWERS}

    def empty_box(self, files: Mapping[str, Path], info_fd: int) -> list[str]:
        """A box without a program. It says "ready" on standard output, and stays until its first process is killed.

        If nobody can hear that, it ends: who wanted it was killed before the box was tied to it.
        """
        waiting = ("/bin/sh", "-c", "echo ready && exec sleep infinity >&-")
        return self.command(waiting, files, {}, info_fd, ("--as-pid-1",))

    def command(
        self,
        command: Sequence[str],
        files: Mapping[str, Path],
        environ: Mapping[str, str],
        info_fd: int,
        more: Sequence[str] = (),
    ) -> list[str]:
        """`command` shut in. `files`: what lies in the answer's folder, by name; `more`: further options.

        The box writes its child's process number to `info_fd` (see `program_pid`).
        """
        boxed = [
            _bwrap(),
            *("--unshare-user", "--unshare-pid", "--unshare-ipc", "--unshare-uts", "--unshare-cgroup-try"),
            *("--die-with-parent", "--new-session", "--cap-drop", "ALL", "--clearenv", "--hostname", "robot"),
            "--disable-userns",
            *("--info-fd", str(info_fd)),
            *more,
        ]
        boxed += ["--proc", "/proc", "--dev", "/dev"]
        for folder in ("/tmp", "/dev/shm", HOME):  # before what is bound below them
            boxed += ["--size", str(WRITABLE_BYTES), "--tmpfs", folder]
        for folder in SYSTEM_FOLDERS:
            path = Path(folder)
            if path.is_symlink():
                boxed += ["--symlink", os.readlink(path), folder]
            elif path.is_dir():
                boxed += ["--ro-bind", folder, folder]
        for name in SYSTEM_FILES:
            boxed += ["--ro-bind-try", name, name]
        for path in self.readable:
            boxed += ["--ro-bind", str(path), str(path)]
        for name, path in files.items():
            boxed += ["--ro-bind", str(path), f"{ANSWER_FOLDER}/{name}"]
        for name, value in self.environment(environ).items():
            boxed += ["--setenv", name, value]
        for folder in READ_ONLY:  # after everything that is bound below them
            boxed += ["--remount-ro", folder]
        return [*boxed, "--chdir", HOME, "--", *command]


def interpreter_folders() -> tuple[Path, ...]:
    """Where Python, its packages, and what runs an answer lie; nothing of the course besides."""
    ours = tuple(_PACKAGE / "observing" / name for name in ("host.py", "powers.py"))
    profile = _PACKAGE / "ros" / "loopback.xml"
    folders = {Path(sys.base_prefix).resolve(), Path(sys.prefix).resolve(), Path(sys.prefix)}
    system = tuple(Path(folder) for folder in SYSTEM_FOLDERS)
    wanted = [
        one for one in sorted(folders) if not any(one == base or base in one.parents for base in system)
    ]
    return (*wanted, *ours, profile)


def first_pid(info: str) -> int | None:
    """The first process of the box, from what it wrote; None while it is not there."""
    try:
        return int(json.loads(info)["child-pid"])
    except (ValueError, KeyError, TypeError):
        return None


def program_pid(info: str) -> int | None:
    """The process that runs the program, from what the box wrote; None while it is not there.

    The box's child is the first process of the new process space; the program is the child of that.
    """
    first = first_pid(info)
    try:
        children = Path(f"/proc/{first}/task/{first}/children").read_text().split()
    except OSError:
        return None
    return int(children[0]) if children else None


def exit_status(code: int) -> int:
    """The exit code of the program as `subprocess` would tell it: negative for a signal.

    The box says 128 + n for a program that signal n has ended. 130 is left alone: Python itself says it for Ctrl-C.
    """
    return 128 - code if 128 < code <= 128 + 31 and code != 130 else code


@cache
def sandbox_problem() -> str | None:
    """Why programs cannot be shut in here, and what to do; None when they can. Tries it, once."""
    if shutil.which("bwrap") is None:
        return "bubblewrap is not installed (apt install bubblewrap)"
    read_fd, write_fd = os.pipe()
    try:
        inner = Cage(readable=()).command(["/bin/true"], {}, {}, write_fd)
        done = subprocess.run(
            outer_command(inner), capture_output=True, text=True, timeout=_SELF_TEST_S, pass_fds=[write_fd]
        )
    except subprocess.TimeoutExpired:
        return "bubblewrap does not come to an end"
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
