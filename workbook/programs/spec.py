"""Specify a run: the program, its arguments, and its limits."""

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from workbook.recording.limits import NO_LIMITS, Limits

KEY_BYTES = 32


@dataclass(frozen=True)
class ProgramSpec:
    """A Python file to run as `__main__`, its `arguments`, and the ROS `parameters` for all of its nodes.

    If there's a `driver`, which is another Python file, it runs as `__main__` instead and can import the program as the
    module `answer`. The driver signs its reports with `driver_key`, which the program can't read, so the program can't
    forge a report. If the key is empty, the driver doesn't sign. `check_fields`: whether rclpy checks the types of
    message fields. `in_panel`: whether the panel next to the notebook shows the program's messages.
    """

    file: Path
    arguments: Sequence[str] = ()
    parameters: Mapping[str, object] = field(default_factory=dict)
    driver: Path | None = None
    driver_key: bytes = field(default_factory=lambda: os.urandom(KEY_BYTES), repr=False, compare=False)
    check_fields: bool = False
    limits: Limits = NO_LIMITS
    in_panel: bool = False

    @property
    def command_line(self) -> list[str]:
        """The program's command-line arguments, including the ROS arguments: `sys.argv` without the program's name."""
        return [*self.arguments, *ros_arguments(self.parameters)]


def ros_arguments(parameters: Mapping[str, object]) -> list[str]:
    """Return the command-line arguments that set ROS parameters for all of a program's nodes."""
    if not parameters:
        return []
    arguments = ["--ros-args"]
    for name, value in parameters.items():
        text = str(value).lower() if isinstance(value, bool) else str(value)
        arguments += ["-p", f"{name}:={text}"]
    return arguments
