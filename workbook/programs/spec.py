"""What is to be run: a program, what it is told, and what it may use."""

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from workbook.recording.limits import NO_LIMITS, Limits

KEY_BYTES = 32


@dataclass(frozen=True)
class ProgramSpec:
    """A Python file that is to run as `__main__`, with `arguments` and ROS `parameters` for all of its nodes.

    With a `driver`, that one runs as `__main__` and can import the program as the module `answer`. It signs what it
    reports with `driver_key`, which the program does not get; with an empty key it does not sign. `check_fields`: ROS
    checks the types of message fields. `in_panel`: the panel beside the notebook shows what it publishes.
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
        """What the program finds in `sys.argv` behind its name."""
        return [*self.arguments, *ros_arguments(self.parameters)]


def ros_arguments(parameters: Mapping[str, object]) -> list[str]:
    """Command-line arguments that set ROS parameters for every node of a program; none for no parameters."""
    if not parameters:
        return []
    arguments = ["--ros-args"]
    for name, value in parameters.items():
        text = str(value).lower() if isinstance(value, bool) else str(value)
        arguments += ["-p", f"{name}:={text}"]
    return arguments
