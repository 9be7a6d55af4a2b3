"""The report of `workbook doctor` in a notebook: is this machine ready?"""

import os
import subprocess
import sys

from workbook.ros.environment import is_leftover, uses_wheels

_DOCTOR = ("-P", "-m", "workbook.cli.main", "doctor")
_OK = "✓"
_NAME_ENDS = 22  # a line of the report is sign, word and name, and then what was seen


def doctor() -> bool:
    """Run `workbook doctor` and print its report as it comes, in full only where something needs attention.

    Returns whether the machine is ready.
    """
    # What this kernel set for its own domain would look like leftovers of a sourced ROS.
    environ = {name: value for name, value in os.environ.items() if not (uses_wheels() and is_leftover(name))}
    with subprocess.Popen(
        [sys.executable, *_DOCTOR],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        encoding="utf-8",
        errors="replace",
        env=environ,
    ) as child:
        assert child.stdout is not None
        in_short = False
        for line in child.stdout:
            goes_on = line.startswith(" ")
            in_short = line.startswith(_OK) or (in_short and goes_on)
            if not in_short:
                print(line.rstrip(), flush=True)
            elif not goes_on:
                print(line[:_NAME_ENDS].rstrip(), flush=True)
    return child.returncode == 0
