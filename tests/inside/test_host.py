"""The host runs an answer of any reasonable form as `__main__`, and doesn't interfere with it."""

import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.programs.support import is_gone, wait_until, write
from workbook.inside import RUN
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.ros.domains import lease_domain
from workbook.ros.environment import child_environment

Done = subprocess.CompletedProcess[str]
Run = Callable[..., Done]

NODE = """\
import rclpy
from rclpy.node import Node

class Humanoid(Node):
    def __init__(self):
        super().__init__("humanoid")
        self.create_timer(0.01, self.tick)

    def tick(self):
        print("ticked as", __name__, flush=True)
        raise SystemExit(0)
"""


@pytest.fixture(scope="module")
def domain() -> Iterator[int]:
    with lease_domain() as lease:
        yield lease.domain_id


@pytest.fixture
def run(tmp_path: Path, domain: int) -> Run:
    def run_it(text: str, *arguments: str, host_options: tuple[str, ...] = ()) -> Done:
        program = write(tmp_path, text)
        return subprocess.run(
            [sys.executable, "-P", str(RUN), "host", *host_options, str(program), *arguments],
            env=child_environment(domain, log_folder=tmp_path),
            cwd=tmp_path,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
        )

    return run_it


SHAPES = {
    "a class alone": NODE,
    "a class and main": NODE
    + "\ndef main(args=None):\n    rclpy.init(args=args)\n    rclpy.spin(Humanoid())\n",
    "main behind a guard": NODE
    + "\ndef main():\n    rclpy.init()\n    rclpy.spin(Humanoid())\n\nif __name__ == '__main__':\n    main()\n",
    "main called without a guard": NODE
    + "\ndef main():\n    rclpy.init()\n    rclpy.spin(Humanoid())\n\nmain()\n",
    "a script": NODE + "\nrclpy.init()\nnode = Humanoid()\nrclpy.spin(node)\n",
    "an async main that is never run": NODE
    + """
async def main():
    rclpy.init()
    rclpy.spin(Humanoid())
""",
    "an abstract base and a leaf": NODE.replace("class Humanoid(Node)", "class Robot(Node)")
    + "\nclass Humanoid(Robot):\n    pass\n",
    "several nodes": NODE
    + """
def main():
    rclpy.init()
    executor = rclpy.executors.SingleThreadedExecutor()
    executor.add_node(Node("silent"))
    executor.add_node(Humanoid())
    executor.spin()
""",
    "a context of its own": NODE.replace('__init__("humanoid")', '__init__("humanoid", context=context)')
    + """
context = rclpy.Context()
context.init()
executor = rclpy.executors.SingleThreadedExecutor(context=context)
executor.add_node(Humanoid())
executor.spin()
""",
    "a class under another name": NODE + "\nAlias = Humanoid\n",
}


@pytest.mark.parametrize("shape", SHAPES)
def test_every_reasonable_shape_runs(shape: str, run: Run) -> None:
    done = run(SHAPES[shape])
    assert done.stdout == "ticked as __main__\n", done.stderr
    assert done.returncode == 0


@pytest.mark.parametrize(
    "text",
    [
        NODE.replace("Humanoid", "Left") + NODE.replace("Humanoid", "Right"),
        "import rclpy\n",
        "print('no ROS at all')\n",
        "from rclpy.node import Node\nclass Robot:\n    pass\n",
        "def main(speed):\n    print('called')\n",
    ],
    ids=["two leaf classes", "nothing to run", "no ROS", "no node class", "main needs an argument"],
)
def test_no_help_where_there_is_nothing_to_choose(text: str, run: Run) -> None:
    done = run(text)
    assert done.returncode == 0, done.stderr
    assert "ticked" not in done.stdout
    assert "called" not in done.stdout


@pytest.mark.parametrize(
    "ending",
    [
        "rclpy.init()\nnode = Humanoid()\n",
        "rclpy.init()\nnode = Humanoid()\nrclpy.spin_once(node, timeout_sec=0)\nrclpy.shutdown()\n",
        "rclpy.init()\nrclpy.shutdown()\ndef main():\n    print('called')\n",
    ],
)
def test_a_file_that_called_init_is_never_helped(ending: str, run: Run) -> None:
    done = run(NODE.replace("0.01", "60.0") + ending)
    assert done.returncode == 0, done.stderr
    assert done.stdout == ""


def test_a_node_class_that_was_only_imported_is_not_run(run: Run) -> None:
    done = run("from rclpy.lifecycle import LifecycleNode\nfrom rclpy.node import Node\n")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("raise SystemExit(7)", 7),
        ("import sys; sys.exit()", 0),
        ("import sys; sys.exit('battery low')", 1),
        ("1 / 0", 1),
        ("raise KeyboardInterrupt", 130),
        ("import os; os._exit(9)", 9),
        ("def main():\n    raise SystemExit(5)", 5),
        ("async def main():\n    raise SystemExit(6)", 6),
        ("import os, signal; os.kill(os.getpid(), signal.SIGTERM)", -signal.SIGTERM),
    ],
)
def test_the_exit_code_is_the_programs_own(text: str, code: int, run: Run) -> None:
    assert run(text).returncode == code


def test_a_traceback_shows_the_students_frames_only(run: Run) -> None:
    done = run("def stand_up():\n    raise ValueError('joint 7 is loose')\n\nstand_up()\n")
    assert "answer.py" in done.stderr
    assert "line 4, in <module>" in done.stderr
    assert "line 2, in stand_up" in done.stderr
    assert done.stderr.rstrip().endswith("ValueError: joint 7 is loose")
    assert "host.py" not in done.stderr


def test_a_traceback_from_a_main_that_was_called_for_the_student_has_no_host_in_it(run: Run) -> None:
    done = run("def main():\n    raise ValueError('joint 7 is loose')\n")
    assert "line 2, in main" in done.stderr
    assert "host.py" not in done.stderr


def test_a_traceback_through_what_the_host_has_wrapped_shows_the_students_line(run: Run) -> None:
    """The host wraps rclpy's Context.init, so one of its frames is between the program and rclpy."""
    done = run("import rclpy\nrclpy.init()\nrclpy.init()\n")
    assert done.returncode == 1
    assert 'answer.py", line 3, in <module>' in done.stderr


DRIVER = "import answer\nprint('never here')\n"


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("level = 1 / 0\n", "ZeroDivisionError"),
        ("level = = 1\n", "SyntaxError"),
        ("import rclpy\nrclpy.init()\nrclpy.init()\n", "line 3, in <module>"),
    ],
)
def test_a_traceback_of_an_answer_has_neither_the_driver_nor_the_import_in_it(
    text: str, shown: str, tmp_path: Path, run: Run
) -> None:
    (tmp_path / "driver.py").write_text(DRIVER)
    done = run(text, host_options=("--driver", str(tmp_path / "driver.py")))
    assert done.returncode == 1 and done.stdout == ""
    assert shown in done.stderr and 'answer.py", line' in done.stderr
    assert "driver.py" not in done.stderr and "importlib" not in done.stderr and "host.py" not in done.stderr


def test_a_syntax_error_names_file_line_and_place(run: Run) -> None:
    done = run("import rclpy\nspeed = = 3\n")
    assert done.returncode == 1
    assert 'answer.py", line 2' in done.stderr
    assert "speed = = 3" in done.stderr
    assert "^" in done.stderr
    assert "SyntaxError: invalid syntax" in done.stderr
    assert "host.py" not in done.stderr


@pytest.mark.parametrize("content", ["x = '\0'\n", "def f(" * 300], ids=["zero byte", "never closed"])
def test_what_python_cannot_read_ends_with_an_error_and_no_host_frames(content: str, run: Run) -> None:
    done = run(content)
    assert done.returncode == 1
    assert "Error" in done.stderr
    assert "host.py" not in done.stderr


def test_the_program_sees_itself_as_the_main_module(run: Run) -> None:
    done = run(
        """
        import sys, __main__
        from dataclasses import dataclass
        @dataclass
        class Pose:
            angle: float
        print(__main__.Pose is Pose, __file__.endswith('answer.py'), sys.argv[0] == __file__, sys.argv[1:])
        """,
        "--ros-args",
        "-p",
        "use_sim_time:=true",
    )
    assert done.stdout == "True True True ['--ros-args', '-p', 'use_sim_time:=true']\n", done.stderr


def test_the_host_leaves_no_name_of_the_workbook_behind(run: Run) -> None:
    done = run(
        "import sys\nprint([name for name in sys.modules if name.startswith('workbook')], sys.path[:1])\n"
    )
    assert done.stdout.startswith("[] "), done.stdout
    assert str(RUN.parent) not in done.stdout


def test_future_statements_of_the_host_do_not_reach_the_answer(run: Run) -> None:
    done = run("def f(x: 1 + 1): ...\nprint(f.__annotations__)\n")
    assert done.stdout == "{'x': 2}\n", done.stderr


@pytest.mark.parametrize(
    ("limit", "text"),
    [
        ("memory=600000000", "import mmap\nmmap.mmap(-1, 2_000_000_000)"),
        ("open_files=20", "files = [open('/dev/null') for _ in range(50)]"),
        (
            "file_size=1000",
            "import signal\nsignal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
            "with open('big', 'wb', buffering=0) as file:\n    assert file.write(bytes(5000)) == 5000\n",
        ),
    ],
    ids=["memory", "open files", "file size"],
)
def test_limits_are_in_force(limit: str, text: str, run: Run) -> None:
    assert run(text).returncode == 0
    assert run(text, host_options=("--limit", limit)).returncode == 1


def test_a_limit_above_the_hard_one_is_cut_and_no_error(run: Run) -> None:
    done = run("print('fine')", host_options=("--limit", "open_files=1000000000"))
    assert done.stdout == "fine\n", done.stderr


def test_the_program_dies_with_the_process_that_started_it(tmp_path: Path, domain: int) -> None:
    """If SIGKILL ends the judge, the answer must end, too."""
    program = write(tmp_path, "import os, time\nprint(os.getpid(), flush=True)\ntime.sleep(600)\n")
    parent = subprocess.Popen(
        [
            sys.executable,
            "-c",
            "import os, subprocess, sys\n"
            "subprocess.run([sys.executable, '-P', sys.argv[1], 'host', '--parent', str(os.getpid()), sys.argv[2]])",
            str(RUN),
            str(program),
        ],
        env=child_environment(domain, log_folder=tmp_path),
        stdout=subprocess.PIPE,
        text=True,
    )
    assert parent.stdout is not None
    pid = int(parent.stdout.readline())
    assert not is_gone(pid)
    parent.kill()
    parent.wait()
    wait_until(lambda: is_gone(pid))
    parent.stdout.close()


def test_a_program_whose_parent_is_gone_already_does_not_start(run: Run) -> None:
    done = run("print('started')\n", host_options=("--parent", str(os.getpid() + 1)))
    assert done.stdout == ""
    assert done.returncode == 1


@pytest.mark.parametrize(
    "text",
    [
        "import traceback\ntraceback.print_stack()\n",
        "import faulthandler\nfaulthandler.dump_traceback()\n",
        "import logging\nlogging.warning('x', stack_info=True)\n",
        "try:\n    import nothing_here\nexcept ImportError as error:\n    raise ValueError('no') from error\n",
        "import warnings\nwarnings.simplefilter('error')\nwarnings.warn('x')\n",
        "import threading\nt = threading.Thread(target=lambda: 1 / 0)\nt.start()\nt.join()\n",
        "import rclpy\nrclpy.init()\nrclpy.init()\n",
        "raise ExceptionGroup('several', [ValueError('a'), OSError('b')])\n",
    ],
    ids=["print_stack", "faulthandler", "logging", "chain", "warning", "thread", "wrapped", "group"],
)
def test_no_list_of_calls_shows_the_host(text: str, tmp_path: Path, domain: int) -> None:
    program = write(tmp_path, text)
    with NodeProcess(ProgramSpec(program), domain) as process:
        assert process.wait(120.0)
    log = process.log.text()
    assert program.name in log and "line " in log
    assert "inside/" not in log and "host.py" not in log and "frozen" not in log, log


def test_each_thread_writes_its_traceback_in_one_piece(run: Run) -> None:
    text = (
        "import threading\nstart = threading.Barrier(8)\ndef work(number):\n"
        "    start.wait()\n    raise ValueError(number)\n"
        "threads = [threading.Thread(target=work, args=(n,)) for n in range(8)]\n"
        "[one.start() for one in threads]\n[one.join() for one in threads]\n"
    )
    blocks = run(text).stderr.split("Exception in thread ")[1:]
    assert len(blocks) == 8
    assert all(one.count("Traceback (most") == 1 and one.count("ValueError: ") == 1 for one in blocks)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("String(data={})", "The field 'data' of String takes string, and got dict: {}"),
        ("String(data=('a',))", "The field 'data' of String takes string, and got tuple: ('a',)"),
        ("Int32(data=1.5)", "The field 'data' of Int32 takes int32, and got float: 1.5"),
        ("UInt8(data=-1)", "The field 'data' of UInt8 takes uint8, and got int: -1"),
        (
            "Float32MultiArray(data=[0.0, 'b'])",
            "The field 'data[1]' of Float32MultiArray takes float, and got str: 'b'",
        ),
        (
            "Twist(linear=(1.0,))",
            "The field 'linear' of Twist takes geometry_msgs/Vector3, and got tuple: (1.0,)",
        ),
        (
            "Header(stamp=node.get_clock().now())",
            "takes builtin_interfaces/Time, and got rclpy.time.Time: Time(",
        ),
        ("Image(data=np.ones((2, 2), dtype=np.uint8))", "takes uint8, and got numpy.ndarray: "),
    ],
)
def test_a_value_that_does_not_fit_is_named_with_its_field(given: str, said: str, run: Run) -> None:
    done = run(
        "import rclpy\nimport numpy as np\nfrom geometry_msgs.msg import Twist\nfrom sensor_msgs.msg import Image\n"
        "from std_msgs.msg import Float32MultiArray, Header, Int32, String, UInt8\n"
        f"rclpy.init()\nnode = rclpy.create_node('a')\nmessage = {given}\n"
        "node.create_publisher(type(message), 'x', 10).publish(message)\n"
    )
    assert said in done.stderr, done.stderr


def test_a_thread_that_keeps_the_program_from_its_end_is_named(tmp_path: Path, domain: int) -> None:
    text = (
        "import threading, time\ndef go_on():\n    while True:\n        time.sleep(0.1)\n"
        "thread = threading.Thread(target=go_on)\nthread.start()\nprint('ready', flush=True)\ntime.sleep(999)\n"
    )
    with NodeProcess(ProgramSpec(write(tmp_path, text)), domain) as process:
        wait_until(lambda: "ready" in process.log.text())
        process.interrupt()
        wait_until(
            lambda: "Still running: Thread-1 (go_on), line " in process.log.text(), instead=process.log.text
        )
