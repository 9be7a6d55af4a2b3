"""If no filter for system calls can be installed, the doctor, the grader, and each result say so."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from workbook.grading.results_file import last_results
from workbook.inside import RUN
from workbook.inside.syscall_filter import against_sandbox_escapes, filter_problem, knows_this_machine
from workbook.isolation.bubblewrap import sandbox_problem
from workbook.isolation.tiers import leaves_open, unfiltered

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
REFUSED = "not filtered: this kernel refuses to install one"
REFUSES = """
import errno, os, sys
from workbook.inside.syscall_filter import PR_SET_SECCOMP, case, compiled, install, not_zero, one_of

PRCTL = 157
conditions = [one_of(0, [PR_SET_SECCOMP]), *([not_zero(2)] if sys.argv[1] == "late" else [])]
install(compiled((), (), [case(PRCTL, errno.EINVAL, *conditions)]))
os.execv(sys.executable, [sys.executable, *sys.argv[2:]])
"""
"""Runs Python in a kernel that refuses filters: "always", or "late": not when it is asked, only at the installation."""

pytestmark = [
    pytest.mark.skipif(not knows_this_machine(), reason="the filter does not know this machine"),
    pytest.mark.skipif(os.geteuid() != 0, reason="only root may refuse filters and still change users"),
]


def refused(when: str, *arguments: object) -> "subprocess.CompletedProcess[str]":
    """Run Python with these arguments in a process that may not install any more filters."""
    command = [sys.executable, "-c", REFUSES, when, *map(str, arguments)]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True)


def test_here_filters_can_be_installed_and_nothing_is_said() -> None:
    assert filter_problem() == "" and against_sandbox_escapes() is not None
    assert unfiltered("sandbox") == ""
    assert "filtered" not in leaves_open("sandbox") + leaves_open("uid")


def test_a_tier_says_that_it_cannot_filter() -> None:
    code = """
from pathlib import Path
from workbook.inside.syscall_filter import against_sandbox_escapes
from workbook.isolation.landlock import LandlockTier
from workbook.isolation.limits import LimitsTier
from workbook.isolation.tiers import leaves_open
assert against_sandbox_escapes() is None
print(leaves_open("sandbox"), leaves_open("uid"), leaves_open("limits"), sep="\\n")
landlock, limits = (tier.confine(Path("/")).unfiltered() for tier in (LandlockTier(), LimitsTier()))
print(f"not filtered: {landlock}", limits, sep="\\n")
"""
    done = refused("always", "-c", code)
    sandbox, uid, limits, of_program, of_limited_program = done.stdout.splitlines()
    assert REFUSED in sandbox and REFUSED in uid and REFUSED in of_program, done.stdout
    assert "filtered" not in limits, "this tier filters nothing anywhere"
    assert of_limited_program == ""


def test_a_filter_that_fails_although_the_kernel_knows_filters_ends_the_program() -> None:
    confine = (RUN, "confine", "--user", "60000", "--", "/bin/echo", "it runs")
    assert refused("always", *confine).stdout == "it runs\n"
    done = refused("late", *confine)
    assert (done.returncode, done.stdout) == (126, "")
    assert "could not be confined" in done.stderr and "seccomp" in done.stderr


@pytest.mark.sandbox
@pytest.mark.slow
@pytest.mark.whole
def test_results_and_pages_say_that_system_calls_were_not_filtered(tmp_path: Path) -> None:
    if problem := sandbox_problem():
        pytest.skip(problem)
    answer = tmp_path / f"{STEM}.py"
    answer.write_text("print('no robot here')\n")
    out = tmp_path / "out"
    options = ("--exercise", STEM, "--out", out, "--isolation", "sandbox", "--format", "html")
    done = refused("always", "-m", "workbook.cli.main", "grade", answer, *options)
    [result] = last_results(out / "results.jsonl").values()
    assert result.status == "graded", done.stderr
    assert REFUSED in result.isolation_problem
    assert REFUSED in done.stdout + done.stderr
    pages = {path.name: path.read_text() for path in (out / "pages").glob("*.html")}
    assert len(pages) == 2
    assert all(REFUSED in page for page in pages.values())


@pytest.mark.sandbox
def test_the_doctor_says_that_system_calls_are_not_filtered() -> None:
    if problem := sandbox_problem():
        pytest.skip(problem)
    code = "from workbook.lab.health import check_sandbox; found = check_sandbox(); print(found.status, found.saw)"
    done = refused("always", "-c", code)
    assert done.stdout.startswith("note ") and REFUSED in done.stdout, done.stdout + done.stderr
