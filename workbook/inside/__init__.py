"""Files that start, confine or end an answer's process, or run in it: `run.py` starts each without the workbook.

They import the standard library and each other (rclpy or mypy where `tests/architecture` names it), never the rest of
the workbook, which may import all of them.
"""

from pathlib import Path

RUN = Path(__file__).with_name("run.py")
"""What to start, with the name of a file of this folder and arguments for it."""
