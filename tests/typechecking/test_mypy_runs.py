"""mypy is loaded once for many runs. It ends with its owner, survives each cleanup, and restarts when killed."""

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from tests.programs.support import is_gone, wait_until
from workbook.inside.proc import children
from workbook.ros.environment import child_environment
from workbook.typechecking.mypy_runs import MypyRun, MypyServer, Outcome

PATIENCE_S = 300.0
MEMORY = 2_500_000_000
QUICK = ("--config-file=", "--no-incremental", "--no-error-summary", "answer.py")
# mypy infers such an argument again for each overload of the enclosing call, so each level multiplies its work. 12
# levels keep any machine busy for longer than a test.
SLOW = f"best = {'sorted([1], key=lambda one: ' * 12}1{')[0]' * 12}\n"
OWNER = """\
import sys
import time
from pathlib import Path
from workbook.typechecking.mypy_runs import MypyRun, mypy_server
from workbook.ros.environment import child_environment

folder = Path(sys.argv[1])
environ = child_environment(0, log_folder=folder)
limits = (60, 2_500_000_000, 300.0)
mypy_server.run(MypyRun(["--version"], folder, environ, *limits))
print(mypy_server.pid, flush=True)
mypy_server.run(MypyRun(["--config-file=", "--no-incremental", "slow.py"], folder, environ, *limits))
time.sleep(600)
"""
SWEEPER = """\
import subprocess
import sys
from pathlib import Path
from workbook.typechecking.mypy_runs import MypyRun, mypy_server
from workbook.inside.orphans import sweep_orphans
from workbook.ros.environment import child_environment

folder = Path(sys.argv[1])

def check():
    environ = child_environment(0, log_folder=folder)
    return mypy_server.run(MypyRun(["answer.py"], folder, environ, 60, 2_500_000_000, 300.0))

check()
before = mypy_server.pid
subprocess.Popen(["sleep", "600"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
print(sweep_orphans(), check().code, mypy_server.pid == before)
"""


@pytest.fixture
def server() -> Iterator[MypyServer]:
    one = MypyServer()
    yield one
    one.close()


def check(
    server: MypyServer, folder: Path, text: str, *, processor_s: int = 60, patience_s: float = PATIENCE_S
) -> Outcome:
    (folder / "answer.py").write_text(text)
    environ = child_environment(0, log_folder=folder)
    return server.run(MypyRun(QUICK, folder, environ, processor_s, MEMORY, patience_s))


def run_under_way(server_pid: int) -> int:
    """Return the process of the run that the server has started."""
    wait_until(lambda: children(server_pid), "the run begins")
    return children(server_pid)[0]


def test_one_process_runs_mypy_again_and_again(server: MypyServer, tmp_path: Path) -> None:
    wrong = check(server, tmp_path, "speed: float = 'fast'\n")
    first = server.pid
    right = check(server, tmp_path, "speed: float = 0.5\n")
    assert (wrong.code, right.code) == (1, 0)
    assert "Incompatible types" in wrong.said and not right.said
    assert server.pid == first


def test_a_complaint_is_no_finding(server: MypyServer, tmp_path: Path) -> None:
    environ = child_environment(0, log_folder=tmp_path)
    outcome = server.run(MypyRun(["--no-such-option"], tmp_path, environ, 60, MEMORY, PATIENCE_S))
    assert outcome.code == 2
    assert "--no-such-option" in outcome.complaint and not outcome.said


def test_one_that_was_killed_is_replaced(server: MypyServer, tmp_path: Path) -> None:
    check(server, tmp_path, "")
    first = server.pid
    assert first is not None
    os.kill(first, signal.SIGKILL)
    wait_until(lambda: is_gone(first), "the server ends")
    assert check(server, tmp_path, "").code == 0
    assert server.pid != first


def test_a_run_that_takes_too_long_ends_and_the_next_one_comes_through(
    server: MypyServer, tmp_path: Path
) -> None:
    check(server, tmp_path, "")
    first = server.pid
    assert first is not None
    with ThreadPoolExecutor() as looking:
        run = looking.submit(run_under_way, first)
        with pytest.raises(TimeoutError):
            check(server, tmp_path, SLOW, patience_s=1.0)
    assert is_gone(run.result())
    assert server.pid is None
    assert check(server, tmp_path, "").code == 0


def test_processor_time_is_limited_for_each_run_alone(server: MypyServer, tmp_path: Path) -> None:
    assert check(server, tmp_path, SLOW, processor_s=1).code in (-signal.SIGXCPU, -signal.SIGKILL)
    assert check(server, tmp_path, "", processor_s=30).code == 0


def test_no_sweep_ends_it(tmp_path: Path) -> None:
    (tmp_path / "answer.py").write_text("")
    done = subprocess.run(
        [sys.executable, "-c", SWEEPER, str(tmp_path)], capture_output=True, text=True, timeout=PATIENCE_S
    )
    assert done.stdout.split() == ["1", "0", "True"], done.stderr


@pytest.mark.parametrize("end", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_it_ends_with_its_owner_in_the_middle_of_a_run(tmp_path: Path, end: signal.Signals) -> None:
    (tmp_path / "slow.py").write_text(SLOW)
    with subprocess.Popen(
        [sys.executable, "-c", OWNER, str(tmp_path)],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    ) as owner:
        assert owner.stdout is not None
        server = int(owner.stdout.readline())
        run = run_under_way(server)
        owner.send_signal(end)
        owner.wait(60)
        wait_until(lambda: is_gone(server) and is_gone(run), "mypy ends")
