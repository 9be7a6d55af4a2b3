"""Programs that are forked into their sandbox: neither the program nor its owner needs to notice."""

import json
import signal
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.programs.support import is_gone, wait_until, write
from workbook.isolation.bubblewrap import sandbox_problem
from workbook.isolation.sandbox import SandboxedFork, SandboxTier
from workbook.programs.fork_client import ForkedProgram, ForkServer
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.recording.limits import Limits
from workbook.ros.domains import lease_domain

pytestmark = pytest.mark.sandbox
LIMITS = Limits(memory=2_500_000_000, open_files=512, cpu=60, core=0, processes=64)
OF_ITSELF = """\
import json, os, resource, signal, socket, sys, time

def started_by_the_first(pid):
    # In a sandbox that waits for a program, the first process waits for another one.
    try:
        return open(f"/proc/{pid}/stat").read().rsplit(")", 1)[1].split()[1] == "1"
    except OSError:  # it has just ended
        return True

def others():
    # Who stays: LTTng starts a process for a moment, some time after it was loaded.
    began = time.monotonic()
    pids = lambda: [int(pid) for pid in os.listdir("/proc") if pid.isdigit()]
    seen = lambda: [pid for pid in pids() if pid not in (1, os.getpid()) and not started_by_the_first(pid)]
    while seen() and time.monotonic() < began + 10:
        time.sleep(0.01)
    return seen()

others()

def capabilities(thread):
    lines = open(f"/proc/self/task/{thread}/status").read().splitlines()
    return [line for line in lines if line.startswith(("Cap", "NoNewPrivs", "Seccomp"))]

status = dict(line.split(":", 1) for line in open("/proc/self/status").read().splitlines())
keep = ("CapInh", "CapPrm", "CapEff", "CapBnd", "CapAmb", "NoNewPrivs", "Uid", "Gid", "SigBlk", "SigIgn", "SigCgt")
print(json.dumps({
    "status": {name: status[name].split() for name in keep},
    "open": sorted(os.listdir("/proc/self/fd"))[:-1],
    "output": [os.fstat(1).st_ino == os.fstat(2).st_ino, sys.stdout.line_buffering, sys.stdout.write_through],
    "mounts": sorted(line.split()[4] for line in open("/proc/self/mountinfo")),
    "environment": dict(os.environ),
    "folder": os.getcwd(),
    "host": socket.gethostname(),
    "threads": sorted(capabilities(thread) for thread in os.listdir("/proc/self/task")),
    "leads its session": os.getsid(0) in (0, os.getpid(), 1),
    "arguments": sys.argv,
    "file": __file__,
    "name": __name__,
    "path": sys.path,
    "flags": list(sys.flags),
    "limits": [resource.getrlimit(number) for number in range(10)],
    "interrupt": str(signal.getsignal(signal.SIGINT)),
    "others": others(),
    "can hide": os.access("/proc/self/mem", os.W_OK),
}))
"""
IMPORTS = (
    "import rclpy",
    "import rclpy.node",
    "from rclpy.node import Node",
    "import rclpy.qos; import std_msgs",
    "from std_msgs.msg import Float32",
    "import std_msgs.msg as messages; from rclpy import executors",
    "from rclpy.executors import SingleThreadedExecutor; import rclpy; rclpy.init(); rclpy.create_node('a_node')",
    "from sensor_msgs.msg import JointState",
    "import numpy",
    "import lark",
    "import rclpy; rclpy.init(); rclpy.create_node('a_node').get_logger().info('logged')",
    "from numpy.linalg import norm; import numpy as np; norm(np.eye(3)); np.random.default_rng(1)",
    "from std_srvs.srv import Trigger; import rclpy; rclpy.init(); rclpy.create_node('a').create_client(Trigger, 'b')",
)
NAMES = """\
{line}
import hashlib, sys
PACKAGES = ("rclpy", "std_msgs", "rosgraph_msgs", "rcl_interfaces", "sensor_msgs", "std_srvs", "numpy")
OF_TYPES = ("rosidl_generator_py", "rosidl_parser", "rosidl_pycommon", "lark", "em")
NOTED = {{"__warningregistry__"}}  # in whatever module is the first to import a deprecated one, as lark 0.12 does
for package in PACKAGES + OF_TYPES:
    seen = [
        (name, module.__name__, getattr(module.__spec__, "name", None), sorted(vars(module).keys() - NOTED))
        for name, module in sorted(sys.modules.items())
        if name.split(".")[0] == package
    ]
    print(package, len(seen), hashlib.sha256(repr(seen).encode()).hexdigest())
"""
Start = Callable[..., NodeProcess]


@pytest.fixture(scope="module")
def server() -> Iterator[ForkServer]:
    problem = sandbox_problem()
    if problem is not None:
        pytest.skip(f"programs cannot be sandboxed: {problem}")
    server = ForkServer()
    yield server
    pid = server.pid
    server.close()
    assert pid is None or is_gone(pid)


@pytest.fixture(scope="module")
def domain() -> Iterator[int]:
    with lease_domain() as lease:
        yield lease.domain_id


@pytest.fixture
def start(tmp_path: Path, domain: int, server: ForkServer) -> Iterator[Start]:
    """Start programs in a sandbox: forked ("warm"), or in a fresh Python."""
    started: list[NodeProcess] = []

    def start_it(text: str, *arguments: str, warm: bool = True) -> NodeProcess:
        (tmp_path / str(len(started))).mkdir()
        program = write(tmp_path / str(len(started)), text)
        spec = ProgramSpec(program, arguments, limits=LIMITS)
        started.append(NodeProcess(spec, domain, SandboxTier(server if warm else None)))
        assert isinstance(started[-1]._child, SandboxedFork) is warm
        return started[-1]

    yield start_it
    for one in started:
        one.stop(patience_s=0.2)
        assert not isinstance(one._child, SandboxedFork) or is_gone(one._child.sandbox.pid)


def finished(program: NodeProcess) -> str:
    """Run a program that ends by itself, and return its log."""
    assert program.wait(60.0)
    program.stop()
    return program.log.text()


def test_a_program_cannot_tell_that_it_was_forked(start: Start) -> None:
    arguments = ("--ros-args", "-p", "use_sim_time:=true")
    warm, fresh = (json.loads(finished(start(OF_ITSELF, *arguments, warm=warm))) for warm in (True, False))
    assert warm == fresh
    assert set(warm["status"]["CapEff"] + warm["status"]["CapBnd"]) == {"0000000000000000"}
    assert warm["status"]["NoNewPrivs"] == ["1"]
    assert warm["others"] == []


@pytest.mark.parametrize("line", IMPORTS)
def test_the_same_modules_appear_as_in_a_fresh_python(start: Start, line: str) -> None:
    warm, fresh = (finished(start(NAMES.format(line=line), warm=warm)) for warm in (True, False))
    assert warm == fresh
    assert "rclpy " in warm


@pytest.mark.parametrize(
    ("name", "value", "text"),
    [
        ("ROS_PYTHON_CHECK_FIELDS", "1", "from std_msgs.msg import Float32\nFloat32(data=1)"),
    ],
)
def test_what_a_program_sets_before_it_imports_counts(start: Start, name: str, value: str, text: str) -> None:
    text = f"import os\nos.environ[{name!r}] = {value!r}\n{text}\n"
    warm, fresh = (finished(start(text, warm=warm)) for warm in (True, False))
    assert warm == fresh
    assert "Error" in warm


def test_what_was_not_imported_is_not_there(start: Start) -> None:
    log = finished(start("import rclpy\nrclpy.node.Node"))
    assert "AttributeError: module 'rclpy' has no attribute 'node'" in log


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("pass", 0),
        ("raise SystemExit(3)", 3),
        ("1 / 0", 1),
        ("import os; os._exit(7)", 7),
        ("import os, signal; os.kill(os.getpid(), signal.SIGKILL)", -9),
        ("import os; os.abort()", -6),
    ],
)
def test_the_end_is_told_as_it_was(start: Start, text: str, code: int) -> None:
    program = start(text)
    finished(program)
    record = program.record()
    seen = record.exit if record.signal is None else -int(signal.Signals[record.signal])
    assert (seen, record.ended_by) == (code, "itself")


def test_an_error_shows_the_answer_and_nothing_of_ours(start: Start) -> None:
    log = finished(start("def fall():\n    1 / 0\n\nfall()\n"))
    assert "ZeroDivisionError" in log
    assert "fork_server" not in log and "host.py" not in log


def test_ctrl_c_reaches_it(start: Start) -> None:
    program = start(
        "import rclpy\nrclpy.init()\nnode = rclpy.create_node('robot')\nprint('ready')\nrclpy.spin(node)\n"
    )
    wait_until(lambda: "ready" in program.log.text())
    program.stop(patience_s=30.0)
    assert not program.killed
    assert "KeyboardInterrupt" in program.record().end_log


def test_what_it_leaves_behind_goes_with_it(start: Start) -> None:
    program = start(
        "import os, time\nif os.fork() == 0:\n    os.setsid()\n    while True:\n        time.sleep(10)\n"
    )
    finished(program)
    assert not program.killed
    assert program.record().exit == 0


def test_two_programs_do_not_throw_the_same_dice(start: Start) -> None:
    text = "import random, uuid\nprint(random.random(), uuid.uuid4())"
    assert finished(start(text)) != finished(start(text))


def test_a_dead_server_costs_nothing_but_time(start: Start, server: ForkServer) -> None:
    finished(start("pass"))
    first = server.pid
    assert server._process is not None
    server._process.kill()
    server._process.wait()
    assert finished(start("print('alive')")) == "alive\n"
    assert server.pid not in (None, first)


def test_where_no_sandbox_can_be_joined_a_fresh_python_is_started(
    tmp_path: Path, domain: int, server: ForkServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    from workbook.programs import fork_client

    monkeypatch.setattr(fork_client.ForkServer, "spawn", refuse)
    spec = ProgramSpec(write(tmp_path, "print('alive')"), limits=LIMITS)
    program = NodeProcess(spec, domain, SandboxTier(server))
    assert not isinstance(program._child, SandboxedFork)
    assert finished(program) == "alive\n"


def refuse(*_: object) -> ForkedProgram:
    from workbook.programs.fork_client import NotForked

    raise NotForked("setns: Operation not permitted")
