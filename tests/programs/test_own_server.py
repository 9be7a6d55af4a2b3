"""Programs that are forked without a sandbox: they can't tell the difference, and none outlives its starter."""

import json
import os
import re
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.programs.support import is_gone, wait_until, write
from tests.programs.test_fork_client import IMPORTS, NAMES, OF_ITSELF, finished
from workbook.inside.proc import children
from workbook.programs import unconfined
from workbook.programs.ending import RUN_MARK, processes_marked
from workbook.programs.fork_client import ForkedProgram, OwnServer
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.programs.tier import Order
from workbook.recording.limits import NO_LIMITS, Limits
from workbook.ros.domains import lease_domain
from workbook.ros.environment import child_environment

LIMITS = Limits(open_files=512, cpu=60, core=0, processes=64)
OWN_FOLDER = re.compile(r"(rclpy-workbook-\d+-\d+-run-)\w+")
ROBOT = "import rclpy\nrclpy.init()\nnode = rclpy.create_node('robot')\nprint('ready', flush=True)\nrclpy.spin(node)\n"
OWNER = """\
import sys
import time
from pathlib import Path
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.programs.fork_client import ForkedProgram, own_server

own_server.keep()
program = NodeProcess(ProgramSpec(Path(sys.argv[1])), int(sys.argv[2]))
assert isinstance(program._child, ForkedProgram)
while "ready" not in program.log.text():
    time.sleep(0.01)
print(own_server.pid, program.pid, flush=True)
program.wait(600.0)
"""
Start = Callable[..., NodeProcess]


@pytest.fixture(scope="module")
def server() -> Iterator[OwnServer]:
    own = OwnServer()
    own.keep()
    yield own
    own.close()


@pytest.fixture(scope="module")
def domain() -> Iterator[int]:
    with lease_domain() as lease:
        yield lease.domain_id


@pytest.fixture
def start(tmp_path: Path, domain: int, server: OwnServer, monkeypatch: pytest.MonkeyPatch) -> Iterator[Start]:
    """Start programs, forked or in a fresh Python."""
    started: list[NodeProcess] = []

    def start_it(text: str, *arguments: str, forked: bool = True, **options: object) -> NodeProcess:
        monkeypatch.setattr(unconfined, "own_server", server if forked else OwnServer())
        program = write(tmp_path, text)
        spec = ProgramSpec(program, arguments, **options)  # type: ignore[arg-type]
        started.append(NodeProcess(spec, domain))
        assert isinstance(started[-1]._child, ForkedProgram) is forked
        return started[-1]

    yield start_it
    for one in started:
        one.stop(patience_s=0.2)


def of_itself(program: NodeProcess) -> dict[str, object]:
    """Return what a program finds out about itself, without its folder's name and its mark's number."""
    seen = dict(json.loads(OWN_FOLDER.sub(r"\1…", finished(program))))
    seen.pop("others")  # without a sandbox, it sees all processes of the machine
    return seen


def test_a_program_cannot_tell_that_it_was_forked(start: Start) -> None:
    text = OF_ITSELF.replace("began + 10", "began")
    arguments = ("--ros-args", "-p", "use_sim_time:=true")
    forked, fresh = (of_itself(start(text, *arguments, forked=one, limits=LIMITS)) for one in (True, False))
    assert forked == fresh


@pytest.mark.parametrize("line", IMPORTS)
def test_the_same_modules_appear_as_in_a_fresh_python(start: Start, line: str) -> None:
    forked, fresh = (finished(start(NAMES.format(line=line), forked=one)) for one in (True, False))
    assert forked == fresh
    assert "rclpy " in forked


def test_an_error_shows_the_program_and_nothing_of_ours(start: Start) -> None:
    log = finished(start("def fall():\n    1 / 0\n\nfall()\n"))
    assert "ZeroDivisionError" in log
    assert "fork_server" not in log and "host.py" not in log


def test_others_find_the_mark_of_this_program_and_of_no_other(start: Start) -> None:
    programs = [start(ROBOT), start(ROBOT)]
    wait_until(lambda: all("ready" in one.log.text() for one in programs))
    assert [processes_marked(one._mark) for one in programs] == [[one.pid] for one in programs]


def test_a_dead_server_costs_nothing_but_time(start: Start, server: OwnServer) -> None:
    assert server.ready() is not None
    first = server.pid
    assert first is not None
    os.kill(first, signal.SIGKILL)
    os.waitid(os.P_PID, first, os.WEXITED | os.WNOWAIT)
    assert finished(start("print('alive')")) == "alive\n"
    assert server.pid not in (None, first)


def test_a_server_that_cannot_fork_is_no_obstacle(
    tmp_path: Path, domain: int, server: OwnServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    from tests.programs.test_fork_client import refuse
    from workbook.programs import fork_client

    assert server.ready() is not None
    monkeypatch.setattr(unconfined, "own_server", server)
    monkeypatch.setattr(fork_client.ForkServer, "spawn", refuse)
    program = NodeProcess(ProgramSpec(write(tmp_path, "print('alive')")), domain)
    assert not isinstance(program._child, ForkedProgram)
    assert finished(program) == "alive\n"


def test_a_server_that_does_not_come_up_is_no_obstacle(
    tmp_path: Path, domain: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    from workbook.programs import fork_client

    own = OwnServer()
    own.keep()
    monkeypatch.setattr(fork_client, "SERVER", "no_such_file")
    monkeypatch.setattr(unconfined, "own_server", own)
    program = NodeProcess(ProgramSpec(write(tmp_path, "print('alive')")), domain)
    assert not isinstance(program._child, ForkedProgram)
    assert finished(program) == "alive\n"
    own.close()


def test_the_first_program_is_forked_too(
    tmp_path: Path, domain: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    own = OwnServer()
    own.keep()
    monkeypatch.setattr(unconfined, "own_server", own)
    before = time.monotonic()
    program = NodeProcess(ProgramSpec(write(tmp_path, "print('alive')")), domain)
    assert isinstance(program._child, ForkedProgram)
    assert program.started_at - before > time.monotonic() - program.started_at, (
        "the server's start counts as its own"
    )
    assert finished(program) == "alive\n"
    own.close()


def test_nobody_has_a_server_who_has_not_asked_for_one() -> None:
    own = OwnServer()
    assert own.ready() is None
    assert own.pid is None


@pytest.mark.parametrize("signal_number", [signal.SIGKILL, signal.SIGINT])
def test_nothing_outlives_whoever_has_started_it(tmp_path: Path, signal_number: int) -> None:
    program = write(tmp_path, f"import signal\nsignal.signal(signal.SIGTERM, signal.SIG_IGN)\n{ROBOT}")
    with lease_domain() as lease:
        owner = subprocess.Popen(
            [sys.executable, "-c", OWNER, str(program), str(lease.domain_id)],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )
        assert owner.stdout is not None
        pids = [int(word) for word in owner.stdout.readline().split()]
        assert len(pids) == 2 and not any(map(is_gone, pids))
        owner.send_signal(signal_number)
        owner.communicate()
        wait_until(lambda: all(map(is_gone, pids)))


def test_ctrl_c_in_a_terminal_does_not_end_the_server(server: OwnServer) -> None:
    assert server.ready() is not None
    assert server.pid is not None
    assert os.getsid(server.pid) == server.pid


SWEEPER = """\
import sys
import time
from pathlib import Path
from workbook.isolation.limits import LimitsTier
from workbook.inside.orphans import adopt_orphans
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.programs.fork_client import own_server

adopt_orphans()
own_server.keep()
assert own_server.ready() is not None
first = own_server.pid
for name in sys.argv[2:]:
    program = NodeProcess(ProgramSpec(Path(name)), int(sys.argv[1]), LimitsTier())
    program.wait(60.0)
    program.stop()
    print(type(program._child).__name__, program.killed, own_server.pid == first)
"""


def test_what_a_program_leaves_behind_goes_and_the_server_stays(tmp_path: Path, domain: int) -> None:
    daemon = "import os, time\nif os.fork() == 0:\n    os.setsid()\n    time.sleep(600)\n"
    programs = [write(tmp_path, text, f"{number}.py") for number, text in enumerate(("pass", daemon, "pass"))]
    done = subprocess.run(
        [sys.executable, "-c", SWEEPER, str(domain), *map(str, programs)], capture_output=True, text=True
    )
    assert done.stdout.splitlines() == [f"ForkedProgram {killed} True" for killed in (False, True, False)]


def test_a_program_that_nobody_waits_for_ends_and_nobody_hears_of_it(
    server: OwnServer, tmp_path: Path, domain: int, capfd: pytest.CaptureFixture[str]
) -> None:
    """Its owner gives up before it gets the program's process id, so no other process could end the program."""
    warm = server.ready()
    assert warm is not None and warm._channel is not None
    program = write(tmp_path, "import os, time\nprint(os.getpid(), flush=True)\ntime.sleep(600)\n")
    environ = child_environment(domain, log_folder=tmp_path) | {RUN_MARK: "nobody."}
    request = {"namespaces_of": 0, "arguments": [str(program)], "environ": environ, "folder": str(tmp_path)}
    before = set(children(server.pid or 0))
    output = os.memfd_create("what the program says")
    reading, status = os.pipe()
    os.close(reading)
    socket.send_fds(warm._channel, [json.dumps(request).encode()], [output, status])
    os.close(status)
    next_one = warm.spawn(
        0, Order([str(write(tmp_path, "", "next.py"))], environ, NO_LIMITS, output), environ, str(tmp_path)
    )
    assert next_one.wait() == 0, "the one before it was started then"
    next_one.close()
    wait_until(lambda: not set(children(server.pid or 0)) - before and not processes_marked("nobody."))
    os.close(output)
    assert capfd.readouterr().err == ""
