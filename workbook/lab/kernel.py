"""Set up each kernel before its first cell runs."""

import logging
import os
import sys
from pathlib import Path
from typing import Any

MAGICS = "workbook.magics"
STATE = Path(".state", "delivered.json")
"""The file that marks a folder as the student's copy, relative to that folder.

The name is defined again here, because importing `work_folder` takes time.
"""
_START = "from workbook.lab.kernel import start as _start; _start(get_ipython()); del _start"

RESTART = (
    "The course is installed. Now restart the kernel (in Colab: Runtime > Restart session) and run this cell again: "
    "only a Python that starts after the installation finds ROS's libraries."
)

_problems: list[str] = []


def configure(config: Any) -> None:
    """Set up this process's ROS environment and have IPython load the magics once the shell exists.

    `config` is IPython's configuration object. This function never raises, because a kernel that starts and reports the
    problem is more useful than one that doesn't start.
    """
    # If this variable is set (by nbval), ipykernel doesn't capture the output of C code, so ROS logs would be missing.
    os.environ.pop("PYTEST_CURRENT_TEST", None)
    config.IPKernelApp.log_level = (
        logging.ERROR
    )  # the warning about local TCP at each start doesn't help learners
    config.InteractiveShellApp.exec_lines.append(_START)
    try:
        from workbook.inside.proc import OWN_OOM_SCORE
        from workbook.ros.environment import prepare, uses_wheels

        if uses_wheels():
            forget_search_path()
        prepare()
        if "JUPYTERHUB_SERVICE_URL" in os.environ:
            # If the class server runs out of memory, Linux then ends a kernel before a server (which has 300).
            Path(OWN_OOM_SCORE).write_text("600")
    except Exception as error:
        _problems.append(
            f"ROS is not set up in this kernel: {error} (`workbook doctor` in a terminal says more)"
        )


def load_ipython_extension(shell: Any) -> None:
    """Set up a kernel that hasn't read our configuration: `%load_ext workbook.lab.kernel`, before ROS is imported.

    The wheels set the search path for ROS's libraries when Python starts. If the wheels were installed after that, the
    path is missing, so we ask the reader to restart the kernel.
    """
    from workbook.ros.environment import library_path, prepare, uses_wheels

    if uses_wheels() and not library_path(os.environ):
        print(RESTART)
        return
    prepare()
    start(shell)


def forget_search_path() -> None:
    """Remove PYTHONPATH's entries from `sys.path`, because a sourced ROS would hide the wheels' rclpy."""
    foreign = {
        os.path.abspath(entry) for entry in os.environ.get("PYTHONPATH", "").split(os.pathsep) if entry
    }
    sys.path[:] = [entry for entry in sys.path if not entry or os.path.abspath(entry) not in foreign]


def start(shell: Any) -> None:
    """Load the magics into IPython's shell. Problems are printed above the first cell's output."""
    try:
        leave_the_lessons(Path.cwd())
    except OSError as error:
        _problems.append(f"There is no scratch folder for files that lessons write: {error}")
    try:
        if shell.extension_manager.load_extension(MAGICS) == "no load function":
            _problems.append(
                f"{MAGICS} has no load_ipython_extension: the magics of the workbook are not there"
            )
    except Exception as error:
        _problems.append(f"The magics of the workbook did not load: {type(error).__name__}: {error}")
    if _problems:
        shell.events.register("pre_run_cell", _complain)


def leave_the_lessons(folder: Path) -> None:
    """Change to `scratch/` in the student's copy, so that a lesson's own files don't end up among the notebooks."""
    if folder.name == "notebooks" and (folder.parent / STATE).is_file():
        scratch = folder.parent / "scratch"
        scratch.mkdir(exist_ok=True)
        os.chdir(scratch)


def _complain(*_: object) -> None:
    while _problems:
        print(_problems.pop(0), file=sys.stderr)
