"""What happens in each kernel before its first cell."""

import logging
import os
import sys
from pathlib import Path
from typing import Any

MAGICS = "workbook.magics"
STATE = Path(".state", "delivered.json")
"""What the student's copy has, beside `notebooks/` (see `work_folder`, which this module does not wait for)."""
_START = "from workbook.lab.kernel import start as _start; _start(get_ipython()); del _start"

_problems: list[str] = []


def configure(config: Any) -> None:
    """Set up the ROS environment of this process and have the magics loaded when the shell is there.

    `config` is IPython's configuration object. Never raises: a kernel that starts and says what is wrong is
    more use than one that does not start.
    """
    # With this variable set (by nbval) ipykernel does not capture what C code writes, and so no ROS logs.
    os.environ.pop("PYTEST_CURRENT_TEST", None)
    config.IPKernelApp.log_level = (
        logging.ERROR
    )  # a warning about local TCP at each start tells a learner nothing
    config.InteractiveShellApp.exec_lines.append(_START)
    try:
        from workbook.ros.environment import prepare, uses_wheels

        if uses_wheels():
            forget_search_path()
        prepare()
    except Exception as error:
        _problems.append(
            f"ROS is not set up in this kernel: {error} (`workbook doctor` in a terminal says more)"
        )


def forget_search_path() -> None:
    """Take what PYTHONPATH brought off `sys.path`: a sourced ROS would otherwise hide the rclpy of the wheels."""
    foreign = {
        os.path.abspath(entry) for entry in os.environ.get("PYTHONPATH", "").split(os.pathsep) if entry
    }
    sys.path[:] = [entry for entry in sys.path if not entry or os.path.abspath(entry) not in foreign]


def start(shell: Any) -> None:
    """Load the magics into IPython's shell; whatever went wrong is said above the output of the first cell."""
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
    """In the student's copy, work in `scratch/` beside the lessons: what a lesson writes does not lie among them."""
    if folder.name == "notebooks" and (folder.parent / STATE).is_file():
        scratch = folder.parent / "scratch"
        scratch.mkdir(exist_ok=True)
        os.chdir(scratch)


def _complain(*_: object) -> None:
    while _problems:
        print(_problems.pop(0), file=sys.stderr)
