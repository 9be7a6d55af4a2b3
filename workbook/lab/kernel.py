"""What happens in each kernel before its first cell."""

import os
from typing import Any

MAGICS = "workbook.magics"


def configure(config: Any) -> None:
    """Set up the ROS environment of this process and have IPython load the magics.

    `config` is IPython's configuration object. Never raises: a kernel that starts and says what is wrong is
    more use than one that does not start.
    """
    # With this variable set (by nbval) ipykernel does not capture what C code writes, and so no ROS logs.
    os.environ.pop("PYTEST_CURRENT_TEST", None)
    problems: list[str] = []
    try:
        from workbook.ros.environment import prepare

        prepare()
    except Exception as error:
        problems.append(
            f"ROS is not set up in this kernel: {error}. `workbook doctor` in a terminal says more."
        )
    try:
        __import__(MAGICS)
    except Exception as error:
        problems.append(f"The magics of the workbook did not load: {type(error).__name__}: {error}.")
    else:
        config.InteractiveShellApp.extensions.append(MAGICS)
    if problems:
        lines = [f"import sys; print({problem!r}, file=sys.stderr)" for problem in problems]
        config.InteractiveShellApp.exec_lines.extend(lines)
