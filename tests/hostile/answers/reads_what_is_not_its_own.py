# score: 10
"""Looks for the criteria, the solutions, the files of other students and of the machine: nothing may be there."""
import os

for place in ("@@ROOT@@/solutions", "@@ROOT@@/exercises", "@@ROOT@@/tests", "/etc/passwd", "/var", "/home/root"):
    assert not os.path.exists(place), f"{place} can be seen"
assert set(os.listdir("/answer")) <= {"09_joint_positions.py"}, os.listdir("/answer")
@@GOOD@@