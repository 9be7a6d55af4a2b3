"""The student's program while it runs beside the notebook, on the notebook's own domain."""

import atexit
import os
from pathlib import Path

from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec


class Running:
    """At most one started program per exercise."""

    def __init__(self) -> None:
        self._programs: dict[str, NodeProcess] = {}
        atexit.register(self.stop_all)

    def start(self, stem: str, program: Path, driver: Path | None = None) -> NodeProcess:
        """Start `program`, ending an earlier run of the same exercise first."""
        self.stop(stem)
        spec = ProgramSpec(program, driver=driver, driver_key=b"", in_panel=True)
        process = NodeProcess(spec, int(os.environ["ROS_DOMAIN_ID"]))
        self._programs[stem] = process
        return process

    def stop(self, stem: str) -> NodeProcess | None:
        """End the program of an exercise. Returns it, or None if it was not running."""
        process = self._programs.pop(stem, None)
        if process is None:
            return None
        was_running = process.is_running()
        process.stop()
        return process if was_running else None

    def stop_all(self) -> list[str]:
        """End all programs. Returns the stems of those that were running."""
        return [stem for stem in list(self._programs) if self.stop(stem) is not None]

    def running(self) -> list[str]:
        """The stems of the exercises whose program is running."""
        return [stem for stem, process in self._programs.items() if process.is_running()]
