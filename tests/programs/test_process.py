"""NodeProcess: a limited log, a clean child process, and an end that no child survives."""

import os
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.programs.support import children_of_this_process, is_gone, wait_until, write
from workbook.programs import unconfined
from workbook.programs.domains_used import domains_of_ports
from workbook.programs.ending import kill_programs_of, processes_marked
from workbook.programs.fork_client import ForkedProgram, OwnServer
from workbook.programs.log import LOG_KEPT_BYTES
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.recording.limits import Limits
from workbook.recording.plain_text import plain_text
from workbook.ros import scratch
from workbook.ros.domains import dds_port_range, lease_domain
from workbook.ros.environment import library_path, profile_with_default_times

Start = Callable[..., NodeProcess]


def scratch_folders() -> set[Path]:
    """Return the folders that this process has made and not removed."""
    return set(Path(tempfile.gettempdir()).glob(f"rclpy-workbook-{os.getuid()}-{os.getpid()}-run-*"))


def mapped_shared_memory(pid: int) -> set[str]:
    """Return the shared memory of Fast DDS that a running process maps. It can't leave behind anything else."""
    try:
        maps = Path(f"/proc/{pid}/maps").read_text()
    except OSError:
        return set()
    return {line.split()[-1] for line in maps.splitlines() if "/dev/shm/fast" in line}


@pytest.fixture(scope="module")
def domain() -> Iterator[int]:
    with lease_domain() as lease:
        yield lease.domain_id


@pytest.fixture(scope="module")
def server() -> Iterator[OwnServer]:
    """Provide a server that forks programs immediately."""
    own = OwnServer()
    own.keep()
    wait_until(own.ready)
    yield own
    pid = own.pid
    own.close()
    assert pid is not None and is_gone(pid)


@pytest.fixture(params=["fresh", "forked"])
def start(
    request: pytest.FixtureRequest, tmp_path: Path, domain: int, monkeypatch: pytest.MonkeyPatch
) -> Iterator[Start]:
    """Start programs. At the end, no program, folder, or zombie is left, whatever the test does."""
    started: list[NodeProcess] = []
    forked = request.param == "forked"
    own = request.getfixturevalue("server") if forked else OwnServer()
    monkeypatch.setattr(unconfined, "own_server", own)

    def start_it(text: str, *arguments: str, **options: object) -> NodeProcess:
        program = write(tmp_path, text, f"answer_{len(started)}.py")
        spec = ProgramSpec(program, arguments, **options)  # type: ignore[arg-type]
        started.append(NodeProcess(spec, domain))
        assert isinstance(started[-1]._child, ForkedProgram) is forked
        return started[-1]

    yield start_it
    for one in started:
        assert not mapped_shared_memory(one.pid)
        one.stop(patience_s=0.2)
        assert not processes_marked(one._mark)
        assert one.pid not in children_of_this_process()
    assert not scratch_folders()


def finished(program: NodeProcess) -> str:
    """Run a program that ends by itself, and return its log."""
    assert program.wait(60.0)
    program.stop()
    return program.log.text()


def logged_numbers(program: NodeProcess, count: int) -> list[int]:
    """Return the process ids that the program has printed, once there are `count` of them."""
    wait_until(lambda: len(program.log.text().split()) >= count)
    return [int(word) for word in program.log.text().split()[:count]]


# --- the log ----------------------------------------------------------------------------------------------------


def test_a_short_log_is_kept_whole(start: Start) -> None:
    program = start("import sys\nprint('standing up')\nprint('joint 7 is loose', file=sys.stderr)\n")
    assert finished(program) == "standing up\njoint 7 is loose\n"
    assert not program.record().log_truncated


def test_a_long_log_keeps_both_ends(start: Start) -> None:
    program = start("print('first line')\nfor n in range(20000):\n    print('step', n)\nprint('last line')\n")
    text = finished(program)
    assert text.startswith("first line\nstep 0\n")
    assert text.endswith("step 19999\nlast line\n")
    assert "bytes left out" in text
    assert len(text.encode()) < LOG_KEPT_BYTES + 100
    left_out = int(text.split("… ")[1].split(" bytes")[0])
    size = len("first line\nlast line\n") + sum(len(f"step {n}\n") for n in range(20000))
    assert left_out == size - LOG_KEPT_BYTES
    assert program.record().log_truncated


def test_a_flood_is_stopped(start: Start) -> None:
    program = start(
        """
        import os, sys
        os.write(1, b"before the flood\\n")
        while True:
            os.write(1, b"the robot is fine " * 1000)
        """,
        limits=Limits(output=3_000_000),
    )
    assert program.wait(60.0)
    record = program.record()
    assert record.limits_hit == ("output",)
    assert record.ended_by == "judge"
    assert record.signal == "SIGKILL"
    program.stop()
    assert program.log.text().startswith("before the flood\n")


def test_what_a_program_prints_cannot_command_a_terminal(start: Start) -> None:
    program = start(
        """
        import os
        os.write(1, b"\\x1b[31mred\\x1b[0m \\x1b]0;title\\x07bell\\x07 \\x1b[2Jclear back\\x08 ")
        os.write(1, b"line\\r\\nover\\rwrite \\x9bC1 zero\\x00 caf\\xc3\\xa9 broken\\xff tab\\there\\n")
        """
    )
    text = finished(program)
    assert "red bell clear back line\noverwrite" in text
    assert "café broken\ufffd tab\there\n" in text
    assert not any(ord(c) < 32 and c not in "\n\t" for c in text)
    assert not any(0x7F <= ord(c) < 0xA0 for c in text)


@pytest.mark.parametrize(
    ("raw", "text"),
    [
        (b"\x1b[38;5;196mred\x1b[m", "red"),
        (b"\x1b]8;;http://example\x1b\\link\x1b]8;;\x1b\\", "link"),
        (b"\x1b", ""),
        (b"\x1b[", "["),
        ("grüß".encode(), "grüß"),
        (b"\xed\xa0\x80", "\ufffd\ufffd\ufffd"),
    ],
)
def test_plain_text(raw: bytes, text: str) -> None:
    assert plain_text(raw) == text


DROPPED = (
    "PYTHONPATH",
    "PYTHONSTARTUP",
    "PYTHONOPTIMIZE",
    "ROS_DISTRO",
    "ROS_PYTHON_CHECK_FIELDS",
    "ROS_LOCALHOST_ONLY",
    "RMW_IMPLEMENTATION",
    "AMENT_PREFIX_PATH",
    "COLCON_PREFIX_PATH",
    "CYCLONEDDS_URI",
)


# --- the child --------------------------------------------------------------------------------------------------


def test_the_child_gets_a_clean_environment(
    start: Start, domain: int, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    for name, value in {
        "PYTHONPATH": str(tmp_path),
        "PYTHONSTARTUP": "x.py",
        "PYTHONOPTIMIZE": "2",
        "ROS_DISTRO": "melodic",
        "ROS_PYTHON_CHECK_FIELDS": "1",
        "ROS_LOCALHOST_ONLY": "1",
        "RMW_IMPLEMENTATION": "rmw_cyclonedds_cpp",
        "AMENT_PREFIX_PATH": "/opt/ros/jazzy",
        "COLCON_PREFIX_PATH": "/opt/ros",
        "CYCLONEDDS_URI": "file:///x",
        "LD_PRELOAD": "",
        "SECRET_TOKEN": "hunter2",
    }.items():
        monkeypatch.setenv(name, value)
    own = [folder for folder in os.environ.get("LD_LIBRARY_PATH", "").split(":") if folder]
    monkeypatch.setenv("LD_LIBRARY_PATH", ":".join(["/opt/ros/jazzy/lib", *own]))
    program = start(
        """
        import json, os, sys
        from std_msgs.msg import Float32
        Float32(data="12")  # no field check: as in stock ROS
        print(json.dumps(dict(os.environ)))
        print(os.getcwd())
        """
    )
    log = finished(program)
    environ = __import__("json").loads(log.splitlines()[0])
    assert environ["ROS_DOMAIN_ID"] == str(domain)
    assert "/opt/ros/jazzy/lib" not in environ.get("LD_LIBRARY_PATH", "")
    for gone in (*DROPPED, "SECRET_TOKEN"):
        assert gone not in environ, gone
    assert environ["FASTRTPS_DEFAULT_PROFILES_FILE"].endswith("loopback.xml")
    assert log.splitlines()[1] != os.getcwd()


def test_field_checks_can_be_had(start: Start) -> None:
    text = "from std_msgs.msg import Float32\nFloat32(data='12')\n"
    assert finished(start(text)) == ""
    assert "AssertionError" in finished(start(text, check_fields=True))


def test_the_loader_path_of_another_environment_is_not_inherited() -> None:
    ours = f"{sys.prefix}/lib/python3/site-packages/rclpy"
    done = {"_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1"}
    assert library_path({"LD_LIBRARY_PATH": ours}) == {}
    assert library_path(done | {"LD_LIBRARY_PATH": "/opt/ros/jazzy/lib"}) == {}
    kept = library_path(done | {"LD_LIBRARY_PATH": f"/opt/ros/jazzy/lib:{ours}:"})
    assert kept == done | {"LD_LIBRARY_PATH": ours}


def test_the_child_reads_no_keyboard_and_runs_in_a_session_of_its_own(start: Start) -> None:
    program = start("import os, sys\nprint(repr(sys.stdin.read()), os.getsid(0) == os.getpid())\n")
    assert finished(program) == "'' True\n"


def test_a_program_that_is_not_there_is_said_at_once(tmp_path: Path, domain: int) -> None:
    with pytest.raises(FileNotFoundError, match="there is no program"):
        NodeProcess(ProgramSpec(tmp_path / "nothing.py"), domain)
    assert not scratch_folders()


# --- its end ------------------------------------------------------------------------------------------------------


def test_a_program_that_ends_by_itself(start: Start) -> None:
    program = start("raise SystemExit(3)")
    finished(program)
    record = program.record()
    assert (record.exit, record.signal, record.ended_by) == (3, None, "itself")
    assert record.ended_at is not None
    assert record.ended_at <= record.watched_for
    assert not program.killed


def test_a_program_that_ends_on_ctrl_c(start: Start) -> None:
    program = start(
        """
        import time
        try:
            print("ready", flush=True)
            time.sleep(600)
        except KeyboardInterrupt:
            print("good night", flush=True)
        """
    )
    wait_until(lambda: "ready\n" in program.log.text())
    assert program.record().ended_by is None
    program.stop(patience_s=30.0)
    record = program.record()
    assert (record.exit, record.ended_by) == (0, "judge")
    assert (record.log, record.end_log) == ("ready\n", "good night\n")
    assert not program.killed


def test_a_program_that_ignores_ctrl_c_is_killed(start: Start) -> None:
    program = start(
        """
        import signal, time
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        print("ready", flush=True)
        time.sleep(600)
        """
    )
    wait_until(lambda: "ready" in program.log.text())
    program.stop(patience_s=0.1)
    record = program.record()
    assert program.killed
    assert (record.exit, record.signal, record.ended_by) == (None, "SIGKILL", "judge")


DAEMONS = """
import os, subprocess, sys, time

{own}
child = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(600)"])
print(child.pid, flush=True)
if os.fork() == 0:                      # a daemon: two forks and a session of its own
    os.setsid()
    if os.fork() == 0:
        print(os.getpid(), flush=True)
        time.sleep(600)
    os._exit(0)
{end}
"""


@pytest.mark.parametrize("end", ["time.sleep(600)", ""], ids=["lives on", "ends by itself"])
@pytest.mark.parametrize("own", ["", "import signal; signal.signal(signal.SIGINT, signal.SIG_IGN)"])
def test_daemons_and_children_are_gone_after_stop(start: Start, own: str, end: str) -> None:
    program = start(DAEMONS.format(own=own, end=end))
    pids = logged_numbers(program, 2)
    assert not any(map(is_gone, pids))
    program.stop(patience_s=0.2)
    wait_until(lambda: all(map(is_gone, pids)))
    assert program.killed


def test_a_fork_storm_ends_with_the_program(start: Start) -> None:
    program = start(
        """
        import os, signal, time
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        for _ in range(40):
            if os.fork() == 0:
                os.setsid()
                time.sleep(600)
        print("ready", flush=True)
        time.sleep(600)
        """
    )
    wait_until(lambda: "ready" in program.log.text())
    assert len(processes_marked(program._mark)) == 41
    program.stop(patience_s=0.1)
    assert not processes_marked(program._mark)


def test_stopping_twice_and_interrupting_the_dead_do_nothing(start: Start) -> None:
    program = start("print('done')")
    finished(program)
    before = program.record()
    program.interrupt()
    program.stop()
    assert program.record() == before


def test_the_context_manager_ends_the_program(tmp_path: Path, domain: int) -> None:
    program = write(tmp_path, "import time\nprint('ready', flush=True)\ntime.sleep(600)\n")
    with NodeProcess(ProgramSpec(program), domain) as running:
        wait_until(lambda: "ready" in running.log.text())
        assert scratch_folders()
    assert not running.is_running()
    assert not scratch_folders()


def test_programs_of_a_dead_bench_can_be_swept(start: Start) -> None:
    program = start(DAEMONS.format(own="", end="time.sleep(600)"))
    pids = logged_numbers(program, 2)
    kill_programs_of(1)
    assert not any(map(is_gone, pids))
    kill_programs_of(os.getpid())
    wait_until(lambda: all(map(is_gone, pids)))
    assert program.wait(30.0)


def test_a_node_leaves_nothing_in_shared_memory_and_tells_its_domain(start: Start, domain: int) -> None:
    program = start(
        """
        import rclpy
        from rclpy.node import Node
        rclpy.init()
        node = Node("humanoid")
        print("ready", flush=True)
        rclpy.spin(node)
        """
    )
    wait_until(lambda: "ready" in program.log.text())
    assert program.domains_used() == (domain,)
    assert not mapped_shared_memory(program.pid)
    program.stop(patience_s=0.1)
    assert program.record().domains_used == (domain,)


@pytest.mark.parametrize("write_profile", [None, profile_with_default_times])
def test_a_node_leaves_no_shared_memory_however_it_ends(
    tmp_path: Path, domain: int, write_profile: Callable[[Path], Path] | None
) -> None:
    """A killed node can't leave behind shared memory that it doesn't use."""
    program = write(tmp_path, "import rclpy\nrclpy.init()\nrclpy.spin(rclpy.create_node('humanoid'))\n")
    with NodeProcess(ProgramSpec(program), domain, write_profile=write_profile) as process:
        wait_until(lambda: process.domains_used() == (domain,))
        assert not set().union(*map(mapped_shared_memory, process._child.tree()))


def test_a_node_on_a_domain_of_its_own_choice_is_found_there(start: Start, domain: int) -> None:
    with lease_domain() as other:
        program = start(
            f"""
            import rclpy
            from rclpy.node import Node
            rclpy.init(domain_id={other.domain_id})
            node = Node("humanoid")
            print("ready", flush=True)
            rclpy.spin(node)
            """
        )
        wait_until(lambda: "ready" in program.log.text())
        assert program.domains_used() == (other.domain_id,)
        program.stop(patience_s=5.0)


def test_the_port_that_a_node_sends_from_is_no_domain() -> None:
    listening = {*dds_port_range(17)[10:12], *dds_port_range(30)[12:14]}
    assert domains_of_ports({7002, *listening, 45_410, 65_500}) == (17, 30)
    assert domains_of_ports({dds_port_range(150)[30]}) == ()


def test_folders_of_the_dead_are_swept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    mine = scratch.scratch_folder("test")
    dead = mine.parent / f"rclpy-workbook-{os.getuid()}-999999999-run-abcdef"
    dead.mkdir()
    (dead / "log.txt").write_text("left behind")
    odd = mine.parent / "someone-elses"
    odd.mkdir()
    scratch.sweep_scratch()
    assert mine.is_dir()
    assert odd.is_dir()
    assert not dead.exists()
    odd.rmdir()
    scratch.remove_scratch(mine)
    assert not mine.exists()
