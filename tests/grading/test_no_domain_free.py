"""If another user holds every domain, `workbook check` says who it is and what to do."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from workbook.isolation.bubblewrap import sandbox_problem

ROOT = Path(__file__).resolve().parents[2]
OWN_NETWORK = (
    "bwrap",
    "--dev-bind",
    "/",
    "/",
    "--unshare-net",
    "--cap-add",
    "ALL",
    "--die-with-parent",
    "--",
)
HOLDS_ALL_AND_CHECKS = """
import subprocess, sys
hog = "import sys; from workbook.ros.domains import lease_domain; held = [lease_domain() for _ in range(101)]"
hog += "; print('held', flush=True); sys.stdin.read()"
pipe = subprocess.PIPE
with subprocess.Popen([sys.executable, "-c", hog], stdin=pipe, stdout=pipe, text=True) as holder:
    assert holder.stdout.readline() == "held\\n"
    print("pid", holder.pid, flush=True)
    from workbook.exercise.answers import Answer
    from workbook.magics import checking
    print(checking.judge("09_joint_positions", Answer("x = 1\\n"), print).reason, flush=True)
    holder.stdin.close()
"""


@pytest.mark.sandbox
def test_a_check_without_a_domain_names_the_holder(tmp_path: Path) -> None:
    """This uses a separate network, so that no other test runs out of domains."""
    problem = sandbox_problem()
    if problem is not None:
        pytest.skip(f"no network of its own: {problem}")
    done = subprocess.run(
        [*OWN_NETWORK, sys.executable, "-c", HOLDS_ALL_AND_CHECKS],
        cwd=ROOT,
        env={**os.environ, "XDG_CACHE_HOME": str(tmp_path)},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    pid, reason = done.stdout.split("\n", 1)
    number = pid.removeprefix("pid ")
    assert reason.startswith("No ROS domain from 1 to 101 is free. Leased: 101 domains by you"), reason
    assert f"(process {number}, `{sys.executable[:30]}" in reason
    assert f"(`kill {number}`); then try again." in reason
