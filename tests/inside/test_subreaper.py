"""A process that keeps a command: it ends with the command, and no descendant outlives it or its owner."""

import os
import signal
import subprocess
import sys

import pytest

from tests.programs.support import is_gone, wait_until
from workbook.inside import RUN

DAEMON = "setsid sleep 600 & echo $!"
OWNER = """
import os, subprocess, sys
run, script = sys.argv[1:]
kept = subprocess.Popen([sys.executable, "-I", "-S", run, "subreaper", str(os.getpid()), "/bin/sh", "-c", script])
kept.wait()
"""


def kept(parent: int, script: str) -> "subprocess.CompletedProcess[str]":
    return subprocess.run(
        [sys.executable, "-I", "-S", str(RUN), "subreaper", str(parent), "/bin/sh", "-c", script],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )


@pytest.mark.parametrize(
    ("script", "code"), [("exit 0", 0), ("exit 7", 7), ("kill -KILL $$", -9), ("kill $$", -15)]
)
def test_it_ends_as_the_command_ends(script: str, code: int) -> None:
    assert kept(os.getpid(), script).returncode == code


def test_a_daemon_does_not_outlive_the_command() -> None:
    done = kept(os.getpid(), DAEMON)
    assert done.returncode == 0
    assert is_gone(int(done.stdout))


def test_nothing_outlives_an_owner_that_is_killed() -> None:
    command = [sys.executable, "-c", OWNER, str(RUN), f"{DAEMON}; echo $$; exec sleep 600"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as owner:
        assert owner.stdout is not None
        below = [int(owner.stdout.readline()) for _ in range(2)]
        assert not any(is_gone(pid) for pid in below)
        owner.kill()
    wait_until(lambda: all(is_gone(pid) for pid in below), "what was kept ends")


def test_an_owner_that_has_gone_already_gets_nothing() -> None:
    done = kept(1, "echo started")
    assert (done.returncode, done.stdout) == (-signal.SIGKILL, "")
