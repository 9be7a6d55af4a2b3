# score: 10
"""Starts programs whose command lines and names are those of the judge, so that others take them for it."""
import ctypes
import subprocess
import sys

for names in (
    [sys.executable, "-m", "workbook.grading.slots.worker", "sandbox"],
    [sys.executable, "-m", "workbook.cli.main", "grade"],
):
    subprocess.Popen([*names, "60"][:1] + ["60"], executable="/usr/bin/sleep")
    subprocess.Popen(["\n".join(names), "60"], executable="/usr/bin/sleep")
ctypes.CDLL(None).prctl(15, b") R 1 1 1 (x", 0, 0, 0)
@@GOOD@@
