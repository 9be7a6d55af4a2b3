"""Launch JupyterLab on the student's copy."""

import errno
import os
import shutil
import socket
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from workbook.exercise.course import NoCourse, course_folder, is_from_wheel
from workbook.lab import jupyter_files
from workbook.lab.work_folder import STATE, WorkFolderUpdate, first_lesson, update_work_folder
from workbook.ros.environment import is_leftover, uses_wheels

HUB = "JUPYTERHUB_SERVICE_URL"
"""The variable that JupyterHub sets when it starts us."""
NEW_COPY = "rclpy-workbook"
"""The subfolder created for the student's copy if the course comes from a wheel and the current folder isn't empty."""


def student_folder() -> Path:
    """Return the folder of the student's copy. Raise NoCourse if there is no course.

    In a clone, it's `work/`. If the course was installed from a wheel, it's the nearest folder that already is a copy,
    from the current folder upward. If there is no copy yet, it's the current folder, provided that this folder is empty
    and isn't the home folder. Otherwise, it's the subfolder `rclpy-workbook`.
    """
    course = course_folder()
    if not is_from_wheel():
        return course / "work"
    here = Path.cwd()
    for folder in (here, *here.parents):
        if (folder / STATE).is_file():
            return folder
    is_empty = all(one.name.startswith(".") for one in here.iterdir())
    return here if is_empty and here != Path.home() else here / NEW_COPY


def prepare_copy(course: Path, work: Path) -> WorkFolderUpdate:
    """Update the student's copy and, if the package came in a wheel, Jupyter's settings.

    In a clone, `make env` writes the settings. Raise CannotLaunch if a file can't be written. On a class server, a full
    disk only delays the update, because there, students can delete files only in JupyterLab.
    """
    if is_from_wheel():
        try:
            jupyter_files.install(Path(sys.prefix), sys.executable)
        except OSError as error:
            raise CannotLaunch(
                f"Jupyter's settings cannot be written to {sys.prefix} ({error.strerror}). "
                "Install rclpy-workbook into a separate environment (python3 -m venv)."
            ) from error
    try:
        return update_work_folder(course, work)
    except OSError as error:
        if error.errno == errno.ENOSPC and HUB in os.environ and (work / STATE).is_file():
            print("The disk is full, so the lessons weren't updated.")
            return WorkFolderUpdate()
        raise CannotLaunch(
            f"cannot write the student's copy in {work}: {error.strerror}. "
            "Is the folder yours, and is the disk full? `workbook doctor` says more."
        ) from error


class CannotLaunch(RuntimeError):
    """Raised when JupyterLab can't start. The message says why and what to do."""


def option(arguments: Sequence[str], *names: str) -> str | None:
    """Return an option's value (`--name=value` or `--name value`), or None without it. The last occurrence counts."""
    found = None
    for position, argument in enumerate(arguments):
        name, equals, value = argument.partition("=")
        if name in names:
            following = arguments[position + 1] if position + 1 < len(arguments) else ""
            found = value if equals else following
    return found


def check_port(arguments: Sequence[str]) -> None:
    """Raise CannotLaunch if the user asked for a port that is invalid or in use."""
    wanted = option(arguments, "--port", "--ServerApp.port")
    if wanted is None:
        return
    if not wanted.isdigit() or not 0 <= int(wanted) <= 65535:
        raise CannotLaunch(
            f"--port needs a number from 1 to 65535, not {wanted!r}: make lab ARGS='--port=8899'"
        )
    address = option(arguments, "--ip", "--ServerApp.ip") or "127.0.0.1"
    address = {"*": "0.0.0.0", "localhost": "127.0.0.1"}.get(address, address)
    family = socket.AF_INET6 if ":" in address else socket.AF_INET
    with socket.socket(family, socket.SOCK_STREAM) as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((address, int(wanted)))
        except OSError as error:
            raise CannotLaunch(
                f"Port {wanted} cannot be used ({error.strerror}). Perhaps another JupyterLab is using it: "
                "`.venv/bin/jupyter server list` lists them. Without --port, a free port is chosen."
            ) from error


def check_folders() -> None:
    """Raise CannotLaunch if Jupyter's or IPython's own folders aren't writable."""
    from jupyter_core.paths import jupyter_config_dir, jupyter_data_dir, jupyter_runtime_dir

    ipython = os.environ.get("IPYTHONDIR") or os.path.expanduser("~/.ipython")
    for folder in (jupyter_config_dir(), jupyter_data_dir(), jupyter_runtime_dir(), ipython):
        try:
            Path(folder).mkdir(parents=True, exist_ok=True)
            with tempfile.TemporaryFile(dir=folder):
                pass
        except OSError as error:
            raise CannotLaunch(
                f"JupyterLab stores files in {folder}, but cannot write there ({error.strerror}). Set HOME to a "
                "folder that you own: HOME=/path/to/folder make lab"
            ) from error


def command(arguments: Sequence[str], *, work: Path, lesson: str | None, root_user: bool) -> list[str]:
    """Return the JupyterLab command. The user's arguments come last, so they take precedence."""
    # JupyterHub's own variant of JupyterLab asks the hub who may log in.
    module = "jupyterhub.singleuser" if HUB in os.environ else "jupyterlab"
    line = [sys.executable, "-P", "-m", module, "--log-level=WARN", f"--ServerApp.root_dir={work}"]
    # If we name the shell, Jupyter doesn't start a login shell, which would replace the environment's PATH with the one
    # from /etc/profile.
    shell = os.environ.get("SHELL") or shutil.which("bash") or "/bin/sh"
    line.append(f"--ServerApp.terminado_settings={{'shell_command': [{shell!r}]}}")
    if lesson is not None:
        line.append(f"--LabApp.default_url=/lab/tree/{lesson}")
    if root_user and "--allow-root" not in arguments:
        line.append("--allow-root")
    return [*line, *arguments]


def lab_environment(environ: Mapping[str, str]) -> dict[str, str]:
    """Return environment variables for JupyterLab and its kernels.

    If ROS comes from the wheels, drop the variables that a sourced ROS left behind.
    """
    clean = {name: value for name, value in environ.items() if not (uses_wheels() and is_leftover(name))}
    clean.pop("PYTHONDONTWRITEBYTECODE", None)
    clean["PATH"] = os.pathsep.join([str(Path(sys.executable).parent), clean.get("PATH", os.defpath)])
    return clean


def launch(arguments: Sequence[str]) -> int:
    """Update `work/` and replace this process with JupyterLab. Return an exit code only if that fails."""
    try:
        check_port(arguments)
        check_folders()
        course, work = course_folder(), student_folder()
        first_start = not (work / STATE).is_file()
        for said in prepare_copy(course, work).lines():
            print(said)
    except (CannotLaunch, NoCourse) as problem:
        print(f"workbook lab: {problem}", file=sys.stderr)
        return 1
    # On later starts, no notebook is named, so JupyterLab opens the home page.
    lesson = first_lesson(course) if first_start else None
    print(f"Your notebooks are in {work}. Stop JupyterLab with Ctrl-C here.", flush=True)
    os.chdir(work)
    line = command(arguments, work=work, lesson=lesson, root_user=os.geteuid() == 0)
    sys.stderr.flush()
    try:
        os.execve(line[0], line, lab_environment(os.environ))
    except OSError as error:
        print(
            f"workbook lab: cannot start {line[0]}: {error.strerror}. Run `make env` again.", file=sys.stderr
        )
    return 1
