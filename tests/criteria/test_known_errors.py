"""Common errors in real logs: each program runs once in the host, and its log is explained."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import pytest

from tests.lesson_nodes.ending import ended_in_order
from workbook.criteria.vocabulary.known_errors import (
    ProgramError,
    find_error,
    shutdown_overtaken,
    without_executors_end,
)
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.ros.domains import lease_domain

HEAD = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String
"""
IN_NODE = (
    HEAD
    + """\


class Humanoid(Node):
    def __init__(self):
        super().__init__("humanoid")
        {body}

    def tick(self):
        pass


rclpy.init()
node = Humanoid()
rclpy.spin_once(node, timeout_sec=2.0)
"""
)
IN_NODE_LINE = 9
PATIENCE_S = 120.0
# Between the check and the shutdown, the context shuts down, as in rclpy's thread that handles Ctrl-C.
OVERTAKEN = """\
import linecache
import sys

import rclpy


def overtake(frame, event, argument):
    name = frame.f_code.co_filename
    if not name.endswith("context.py"):
        return None
    if event == "line" and linecache.getline(name, frame.f_lineno).strip() == "self.__context.shutdown()":
        sys.settrace(None)
        frame.f_locals["self"].handle.shutdown()
    return overtake


rclpy.init()
sys.settrace(overtake)
rclpy.try_shutdown()
"""
OVERTAKEN_AFTER_A_MISTAKE = OVERTAKEN.replace(
    "rclpy.try_shutdown()\n", "try:\n    1 / 0\nfinally:\n    rclpy.try_shutdown()\n"
)


@dataclass(frozen=True)
class Case:
    """A program, the error at its end, the responsible line, and a word from the advice."""

    name: str
    program: str
    error: str
    line: int | None
    advice: str
    check_fields: bool = False


def in_node(name: str, body: str, error: str, advice: str, **options: bool) -> Case:
    return Case(name, IN_NODE.format(body=body), error, IN_NODE_LINE, advice, **options)


CASES = [
    Case(
        "with_init", HEAD + "with rclpy.init():\n    pass\n", "TypeError", 4, "rclpy.init() on its own line"
    ),
    Case("no_init", HEAD + "node = Node('humanoid')\n", "NotInitializedException", 4, "rclpy.init() once"),
    Case("init_twice", HEAD + "rclpy.init()\nrclpy.init()\n", "RuntimeError", 5, "exactly once"),
    Case(
        "shutdown_twice",
        HEAD + "rclpy.init()\nrclpy.shutdown()\nrclpy.shutdown()\n",
        "RuntimeError",
        6,
        "rclpy.try_shutdown()",
    ),
    Case("overtaken", OVERTAKEN, "rcl_shutdown already called", 19, "Run the check again"),
    Case(
        "overtaken_after_a_mistake",
        OVERTAKEN_AFTER_A_MISTAKE,
        "ZeroDivisionError",
        20,
        "at the line that raised the error",
    ),
    Case(
        "no_super_init",
        HEAD
        + """\
class Humanoid(Node):
    def __init__(self):
        self.create_timer(1.0, print)
rclpy.init()
Humanoid()
""",
        "AttributeError",
        6,
        "super().__init__",
    ),
    Case(
        "method_named_handle",
        HEAD
        + """\
class Humanoid(Node):
    def __init__(self):
        super().__init__("humanoid")
    def handle(self):
        pass
rclpy.init()
Humanoid()
""",
        "TypeError",
        6,
        "Rename your method handle",
    ),
    in_node(
        "builtin_callback",
        "from collections import deque; self.create_subscription(String, '/s', deque().append, 10)",
        "ValueError",
        "Wrap the method in your own function",
    ),
    in_node("no_depth", "self.create_publisher(String, '/robot/status')", "TypeError", "Add a depth"),
    in_node(
        "other_message",
        "self.create_publisher(Float32MultiArray, 'joints', 10).publish([0.0])",
        "TypeError",
        "Create a message of the publisher's type",
    ),
    in_node(
        "callback_without_a_message",
        "self.create_subscription(String, '/s', self.tick, 10)",
        "RuntimeError",
        "one argument in addition to self",
    ),
    in_node(
        "message_callback_called",
        "self.create_subscription(String, '/s', Humanoid.tick(), 10)",
        "TypeError",
        "without parentheses: self.on_timer",
    ),
    in_node("no_callback", "self.create_timer(1.0)", "TypeError", "create_timer(1.0, self.on_timer)"),
    Case(
        "no_name_for_the_node",
        HEAD
        + """\
class Humanoid(Node):
    def __init__(self):
        super().__init__()
rclpy.init()
Humanoid()
""",
        "TypeError",
        6,
        "super().__init__('your_node_name')",
    ),
    Case(
        "timer_with_a_message",
        IN_NODE.format(body="self.create_timer(0.05, self.tick)").replace(
            "def tick(self)", "def tick(self, msg)"
        ),
        "TypeError",
        None,
        "For a timer, define on_timer(self)",
    ),
    in_node("no_message_class", "self.create_publisher(str, '/s', 10)", "AttributeError", "the class itself"),
    in_node(
        "other_type",
        "[self.create_publisher(kind, '/s', 10) for kind in (String, Float32)]",
        "RCLError",
        "message type per topic name",
    ),
    in_node("name_taken", "self.publishers = []", "AttributeError", "my_publishers"),
    in_node(
        "topic_name",
        "self.create_publisher(String, '/robot/joint-positions', 10)",
        "InvalidTopicNameException",
        "exactly as the exercise gives it",
    ),
    in_node(
        "text_in_floats",
        "Float32MultiArray(data=['0.1'])",
        "TypeError",
        "float(value)",
        check_fields=True,
    ),
    in_node("text_in_float", "Float32(data='0.1')", "AssertionError", "float(value)", check_fields=True),
    in_node("text_in_array", "Float32MultiArray(data=['0.1'])", "TypeError", "float(value)"),
    in_node(
        "undefined",
        "self.pub = self.create_publisher(Joints, 'x', 10)",
        "NameError",
        "Import or define the name",
    ),
    in_node("keyboard", "input('speed? ')", "EOFError", "input()"),
    in_node(
        "own_error",
        "raise ValueError('joint 7 is loose')",
        "ValueError: joint 7 is loose",
        "at the line that raised the error",
    ),
    Case(
        "node_name", HEAD + "rclpy.init()\nNode('my robot')\n", "InvalidNodeNameException", 5, "simple name"
    ),
    Case(
        "callback_called",
        IN_NODE.format(body="self.create_timer(0.05, self.tick())"),
        "TypeError",
        None,
        "without parentheses",
    ),
    Case("no_module", "import rclpie\n", "ModuleNotFoundError", 1, "Check the spelling"),
    Case("no_name", HEAD + "from std_msgs.msg import Floaty\n", "ImportError", 4, "Check the spelling"),
    Case("subscript", HEAD + "x: Node[str]\n", "TypeError", 4, ""),
    Case("indentation", HEAD + "def main():\nrclpy.init()\n", "IndentationError", 5, "four spaces"),
    Case("syntax", HEAD + "rclpy.init(\nx = = 1\n", "SyntaxError", None, "brackets, quotes, and colons"),
    Case("memory", "raise MemoryError\n", "MemoryError", 1, "never stops growing"),
    Case("disk_full", "import os\nraise OSError(28, os.strerror(28))\n", "OSError", 2, "Write less"),
    Case("large_file", "import os\nraise OSError(27, os.strerror(27))\n", "OSError", 2, "Write less"),
    Case(
        "open_files",
        "import os\nraise OSError(24, os.strerror(24))\n",
        "OSError",
        2,
        "Close each file that you open",
    ),
    Case(
        "forks",
        "import os\nraise OSError(11, os.strerror(11))\n",
        "BlockingIOError",
        2,
        "starts a new thread in each iteration",
    ),
    Case("python_two", "print 'hello'\n", "SyntaxError", None, "other Python 2 code"),
    Case("shell_line", "import rclpy\n!rm -rf /\n", "SyntaxError", None, "Remove that line"),
    Case("cell_magic", "%%bash\nrm -rf /\n", "SyntaxError", None, "Remove that line"),
    Case("line_magic", "def main():\n    %load_ext autoreload\n", "SyntaxError", None, "Remove that line"),
    Case("no_such_name", "import rclpy\nrclpy.inti()\n", "AttributeError", 2, "did you mean init?"),
    Case(
        "shadow",
        "import os, sys\nos.makedirs('own')\nopen('own/geometry_msgs.py', 'w').close()\nsys.path.insert(0, 'own')\n"
        "from geometry_msgs.msg import Twist\n",
        "ModuleNotFoundError",
        5,
        "Rename that file",
    ),
    Case(
        "in_a_thread",
        "import threading\ndef work():\n    missing_name\nt = threading.Thread(target=work)\nt.start()\nt.join()\n",
        "NameError",
        3,
        "Import or define the name",
    ),
    Case(
        "while_handling",
        "try:\n    1 / 0\nexcept ZeroDivisionError:\n    unknown\n",
        "ZeroDivisionError",
        2,
        "at the line that raised the error",
    ),
]


def run_through_host(case: Case, folder: Path, domain_id: int) -> str:
    program = folder / f"{case.name}.py"
    program.write_text(case.program)
    with NodeProcess(ProgramSpec(program, check_fields=case.check_fields), domain_id) as process:
        assert process.wait(PATIENCE_S)
    return process.log.text()


@pytest.fixture(scope="module")
def logs(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    folder = tmp_path_factory.mktemp("errors")
    with lease_domain() as lease, ThreadPoolExecutor(4) as pool:
        texts = pool.map(lambda case: run_through_host(case, folder, lease.domain_id), CASES)
        return {case.name: text for case, text in zip(CASES, texts, strict=True)}


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_a_real_traceback_is_explained(case: Case, logs: dict[str, str]) -> None:
    log = logs[case.name]
    error = find_error(log, f"{case.name}.py")
    assert isinstance(error, ProgramError), log
    assert case.error in error.error, log
    assert case.line is None or error.line == case.line, (error, log)
    assert case.advice in error.try_this, (error, log)
    assert error.because


def test_the_line_is_the_students_own(logs: dict[str, str]) -> None:
    """rclpy's frames are deeper in the traceback, but the student can only fix their own file."""
    error = find_error(logs["topic_name"], "topic_name.py")
    assert error is not None
    assert error.where == f"line {IN_NODE_LINE}: "
    elsewhere = find_error(logs["topic_name"], "another.py")
    assert elsewhere is not None
    assert elsewhere.line is None
    assert elsewhere.where == ""


def test_only_an_end_that_ctrl_c_overtook_is_an_end_in_order_with_a_traceback(logs: dict[str, str]) -> None:
    assert [name for name, log in logs.items() if shutdown_overtaken(log)] == ["overtaken"]
    assert [name for name, log in logs.items() if ended_in_order(1, log)] == ["overtaken"]
    assert not ended_in_order(0, logs["no_init"])
    assert ended_in_order(0, "[INFO] [humanoid]: good night\n")
    assert not ended_in_order(1, "")
    assert not ended_in_order(None, logs["overtaken"])


# A spin queries its nodes before it waits. At this moment, the context shuts down in one of the possible ways.
SPIN_OVERTAKEN = """\
import threading

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


def spin(node):
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


def overtake():
    nodes = get_nodes()
    {shutdown}
    return nodes


rclpy.init()
node = Node("humanoid")
executor = rclpy.get_global_executor()
get_nodes, executor.get_nodes = executor.get_nodes, overtake
{spin}
print("good night")
"""
BY_RCL, BY_RCLPY = "executor.context.handle.shutdown()", "rclpy.try_shutdown()"
IN_THREAD = "receiving = threading.Thread(target=spin, args=(node,)); receiving.start(); receiving.join()"


def end_of(program: str, folder: Path) -> str:
    with lease_domain() as lease:
        return run_through_host(Case("left", program, "", None, ""), folder, lease.domain_id)


@pytest.mark.parametrize("shutdown", [BY_RCL, BY_RCLPY])
def test_a_thread_whose_spin_is_overtaken_by_the_shutdown_is_no_mishap(shutdown: str, tmp_path: Path) -> None:
    log = end_of(SPIN_OVERTAKEN.format(shutdown=shutdown, spin=IN_THREAD), tmp_path)
    assert "Exception in thread" in log and "_wait_for_ready_callbacks" in log
    assert without_executors_end(log) == "good night\n"
    assert find_error(log, "left.py") is None
    assert ended_in_order(0, log) and not ended_in_order(1, log)


def test_a_thread_that_fails_by_itself_is_one(tmp_path: Path) -> None:
    failing = 'node.create_timer(0.01, lambda: {}["joint"])'
    log = end_of(SPIN_OVERTAKEN.format(shutdown="pass", spin=f"{failing}; {IN_THREAD}"), tmp_path)
    assert not ended_in_order(0, log)
    assert (found := find_error(log, "left.py")) is not None and found.error == "KeyError: 'joint'"


@pytest.mark.parametrize("shutdown", [BY_RCL, BY_RCLPY])
def test_a_spin_that_ctrl_c_overtakes_is_an_end_in_order(shutdown: str, tmp_path: Path) -> None:
    log = end_of(SPIN_OVERTAKEN.format(shutdown=shutdown, spin="spin(node)"), tmp_path)
    assert "good night" not in log
    assert shutdown_overtaken(log) and ended_in_order(1, log)


TAKE_OVERTAKEN = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Humanoid(Node):
    def __init__(self):
        super().__init__("humanoid")
        self.publisher = self.create_publisher(String, "/robot/status", 10)
        self.create_subscription(String, "/robot/status", print, 10)
        self.create_timer(0.05, self.tick)

    def tick(self):
        self.publisher.publish(String(data="operational"))


make = String.__init__


def interrupted(self, **fields):
    if not fields:
        raise KeyboardInterrupt
    make(self, **fields)


rclpy.init()
node = Humanoid()
String.__init__ = interrupted
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    print("good night")
"""


def test_a_message_in_the_middle_of_which_ctrl_c_comes_is_an_end_in_order(tmp_path: Path) -> None:
    """Python raises KeyboardInterrupt at the first bytecode after the signal: here, in the message's class."""
    log = end_of(TAKE_OVERTAKEN, tmp_path)
    assert "Unable to convert call argument" in log and "good night" not in log
    assert shutdown_overtaken(log) and ended_in_order(1, log)
    assert (found := find_error(log, "left.py")) is not None and found.cause == "error.shutdown-overtaken"
    again = log.replace("_take_subscription", "tick")
    assert not shutdown_overtaken(again)


EXECUTOR_LEFT = """\
import rclpy
from rclpy.executors import SingleThreadedExecutor

rclpy.init()
executor = SingleThreadedExecutor()
executor._sigint_gc.destroy()  # what the garbage collector does when it comes to this first
del executor
rclpy.shutdown()
print("good night")
"""


def test_an_executor_that_outlives_a_part_of_it_is_no_mishap(tmp_path: Path) -> None:
    log = end_of(EXECUTOR_LEFT, tmp_path)
    assert "Exception ignored in: <function Executor.__del__" in log and "InvalidHandle" in log
    assert without_executors_end(log) == "good night\n"
    assert find_error(log, "left.py") is None
    assert ended_in_order(0, log) and not ended_in_order(1, log)
    after = f"{log}Traceback (most recent call last):\n  File \"left.py\", line 3, in tick\nKeyError: 'x'\n"
    assert not ended_in_order(0, after)
    assert (found := find_error(after, "left.py")) is not None and found.error == "KeyError: 'x'"


@pytest.mark.parametrize(
    "log",
    [
        "",
        "[INFO] [humanoid]: No Error so far",
        "[ERROR] [humanoid]: ValueError: joint 7 is loose",
        "ValueError: printed by the student",
        "Error: battery low\nValueError\nAll good",
        "The tutorial says: Traceback (most recent call last) is what one sees after an error",
        "NotARealException: only a word in a log\n[INFO] [humanoid]: still running",
        "Traceback (most recent call last):\n"
        '  File "/answers/answer.py", line 3, in <module>\n    rclpy.spin(node)\nKeyboardInterrupt\n',
    ],
)
def test_a_log_that_only_mentions_errors_is_no_mishap(log: str) -> None:
    assert find_error(log, "answer.py") is None


def test_a_truncated_traceback_still_tells_the_error() -> None:
    log = (
        '… 9000 bytes left out …\n  File "/answers/answer.py", line 31, in tick\n    angle / 0\n'
        "ZeroDivisionError: division\n"
    )
    error = find_error(log, "answer.py")
    assert error is not None
    assert (error.error, error.line) == ("ZeroDivisionError: division", 31)


def test_a_library_that_is_refused_a_thread_is_told_what_to_do() -> None:
    """When PyTorch can't start a thread, OpenMP ends the process without a traceback.

    A program may also print other last lines.
    """
    log = "Error in cpuinfo: failed\n\nlibgomp: Thread creation failed: Resource temporarily unavailable\n"
    error = find_error(log)
    assert error is not None
    assert (error.cause, error.line) == ("error.too-many-threads", None)
    assert "64" in error.because
    assert "OMP_NUM_THREADS" in error.try_this
    assert find_error(f"{log}and so I stop\n") is None
