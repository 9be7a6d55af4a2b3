"""Show in a notebook whether this machine is ready, with the report of `workbook doctor`."""

import os
import subprocess
import sys

from workbook.ros.environment import is_leftover, uses_wheels

_DOCTOR = ("-P", "-m", "workbook.cli.main", "doctor")
_OK = "✓"
_NAME_ENDS = 22  # a report line consists of a sign, a word, a name, and then the finding


def doctor() -> bool:
    """Check this machine with `workbook doctor` and print the report. Return whether the machine is ready.

    For a finding that is OK, print only its name.
    """
    # The doctor would report this kernel's own ROS variables as leftovers of a sourced ROS.
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
