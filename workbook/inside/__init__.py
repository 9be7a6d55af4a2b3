"""Stand-alone modules around an answer's process: they start, confine, inspect, or kill it, or run in it.

Some are scripts, such as the servers that fork programs or run mypy. `run.py` starts each script without importing the
rest of the package `workbook`. Others, such as `proc.py`, are only imported. These files import only the standard
library and each other. Some also import rclpy or mypy, where `tests/architecture` allows it. They never import the rest
of `workbook`, which may import all of them.
"""

from pathlib import Path

RUN = Path(__file__).with_name("run.py")
"""The script to start. Its arguments are the name of a file in this folder, and the arguments for that file."""
