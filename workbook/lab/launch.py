"""Starting JupyterLab on the student's copy."""

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

NEW_COPY = "rclpy-workbook"
"""Folder that a wheel makes for the student's copy where other files are already."""


def student_folder() -> Path:
    """The student's own copy: `work/` in a clone's folder. Raises NoCourse.

    A wheel's copy is where the student stands: in a copy or below it, in an empty folder, or else in a folder
    `rclpy-workbook` next to the files that are there.
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
    """Bring the student's copy up to date and, if the package came in a wheel, Jupyter's settings as well.

    In a clone, `make env` writes the settings. Raises CannotLaunch.
    """
    if is_from_wheel():
        try:
            jupyter_files.install(Path(sys.prefix), sys.executable)
        except OSError as error:
            raise CannotLaunch(
                f"Jupyter's settings cannot be written to {sys.prefix} ({error.strerror}). "
                "Install rclpy-workbook into an environment of your own (python3 -m venv)."
            ) from error
    try:
        return update_work_folder(course, work)
    except OSError as error:
        raise CannotLaunch(
            f"cannot write the student's copy in {work}: {error.strerror}. "
            "Is the folder yours, and is the disk full? `workbook doctor` says more."
        ) from error


class CannotLaunch(RuntimeError):
    """JupyterLab cannot start; the text says why and what to do."""


def option(arguments: Sequence[str], *names: str) -> str | None:
    """The value of a command line option written `--name=value` or `--name value`; the last one counts."""
    found = None
    for position, argument in enumerate(arguments):
        name, equals, value = argument.partition("=")
        if name in names:
            following = arguments[position + 1] if position + 1 < len(arguments) else ""
            found = value if equals else following
    return found


def check_port(arguments: Sequence[str]) -> None:
    """Raise CannotLaunch when the person asked for a port that is no number or is taken."""
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
                f"Port {wanted} cannot be used ({error.strerror}). Perhaps another JupyterLab has it: "
                f"`.venv/bin/jupyter server list` shows them. Without --port a free one is taken."
            ) from error


def check_folders() -> None:
    """Raise CannotLaunch when Jupyter or IPython cannot write where they keep their files."""
    from jupyter_core.paths import jupyter_config_dir, jupyter_data_dir, jupyter_runtime_dir

    ipython = os.environ.get("IPYTHONDIR") or os.path.expanduser("~/.ipython")
    for folder in (jupyter_config_dir(), jupyter_data_dir(), jupyter_runtime_dir(), ipython):
        try:
            Path(folder).mkdir(parents=True, exist_ok=True)
            with tempfile.TemporaryFile(dir=folder):
                pass
        except OSError as error:
            raise CannotLaunch(
                f"JupyterLab keeps files in {folder}, and they cannot be written there ({error.strerror}). "
                "Set HOME to a folder of yours: HOME=/path/to/folder make lab"
            ) from error


def command(arguments: Sequence[str], *, work: Path, lesson: str | None, root_user: bool) -> list[str]:
    """The JupyterLab command; what the person passes comes last and so wins."""
    line = [sys.executable, "-P", "-m", "jupyterlab", "--log-level=WARN", f"--ServerApp.root_dir={work}"]
    # Named, it is no login shell: that would put /etc/profile's PATH in the place of the environment's.
    shell = os.environ.get("SHELL") or shutil.which("bash") or "/bin/sh"
    line.append(f"--ServerApp.terminado_settings={{'shell_command': [{shell!r}]}}")
    if lesson is not None:
        line.append(f"--LabApp.default_url=/lab/tree/{lesson}")
    if root_user and "--allow-root" not in arguments:
        line.append("--allow-root")
    return [*line, *arguments]


def lab_environment(environ: Mapping[str, str]) -> dict[str, str]:
    """The environment for JupyterLab and its kernels: without what a sourced ROS left, on the wheels route."""
    clean = {name: value for name, value in environ.items() if not (uses_wheels() and is_leftover(name))}
    clean.pop("PYTHONDONTWRITEBYTECODE", None)
    clean["PATH"] = os.pathsep.join([str(Path(sys.executable).parent), clean.get("PATH", os.defpath)])
    return clean


def launch(arguments: Sequence[str]) -> int:
    """Bring `work/` up to date and become JupyterLab; returns only when that is impossible (exit code)."""
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
    # On later starts, JupyterLab without a notebook in its address opens at home.
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
