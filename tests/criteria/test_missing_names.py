"""Names that an object or module doesn't have: each program runs in the host, and the feedback gives the right name."""

from concurrent.futures import ThreadPoolExecutor

import pytest

from tests.criteria.test_known_errors import IN_NODE, Case, run_through_host
from workbook.criteria.vocabulary.known_errors import ProgramError, find_error
from workbook.ros.domains import lease_domain

TICK = "    def tick(self):\n        pass\n"


def in_callback(code: str) -> str:
    """Return a program whose timer runs this code."""
    text = IN_NODE.format(body="self.pub = self.create_publisher(String, 'x', 10)")
    text = text.replace(TICK, f"    def tick(self):\n        {code}\n")
    return text.replace("10)\n", "10); self.create_timer(0.01, self.tick)\n")


def in_constructor(code: str) -> str:
    return IN_NODE.format(body=code)


MISSPELLED = "error.name-misspelled"
CASES = {
    "node_in_constructor": (in_constructor("self.creat_timer(1.0, self.tick)"), MISSPELLED, "create_timer?"),
    "publisher": (in_constructor("self.create_publsher(String, 'x', 1)"), MISSPELLED, "create_publisher?"),
    "node_in_callback": (in_callback("self.get_loger().info('a')"), MISSPELLED, "get_logger?"),
    "of_a_publisher": (in_callback("self.pub.publsh(String())"), MISSPELLED, "mean publish?"),
    "of_rclpy": ("import rclpy\nrclpy.inti()\n", MISSPELLED, "init?"),
    "imported": ("from rclpy.node import Nod\n", MISSPELLED, "Node?"),
    "module": ("from std_msg.msg import String\n", MISSPELLED, "std_msgs?"),
    "submodule": ("from rclpy.executers import Executor\n", MISSPELLED, "executors?"),
    "policy": (
        "from rclpy.qos import DurabilityPolicy\nDurabilityPolicy.TRANSIENT\n",
        MISSPELLED,
        "TRANSIENT_LOCAL?",
    ),
    "own": (in_callback("self.publ.publish(String())"), MISSPELLED, "pub?"),
    "masked": (
        in_constructor("self.creat_timer(1.0, self.tick)").replace(
            "node = Humanoid()", "try:\n    node = Humanoid()\nfinally:\n    node.destroy_node()"
        ),
        MISSPELLED,
        "create_timer?",
    ),
    "in_a_thread": (
        "import threading, rclpy\nt = threading.Thread(target=lambda: rclpy.inti())\nt.start()\nt.join()\n",
        MISSPELLED,
        "init?",
    ),
    "field": (in_callback("String().dta = 'a'"), "error.unknown-field", "Use data instead"),
    "field_that_is_read": (in_callback("print(String().dta)"), "error.unknown-field", "Use data instead"),
    "set_later": (
        in_constructor("self.tick(); self.level = 1.0").replace("        pass", "        print(self.level)"),
        "error.attribute-set-later",
        "self.level in __init__",
    ),
    "of_a_publisher_not_of_the_node": (
        in_callback("self.publish(String())"),
        "error.method-of-another-class",
        "create_publisher() returned",
    ),
    "of_the_node_not_of_rclpy": (
        in_constructor("rclpy.create_timer(1.0, self.tick)"),
        "error.method-of-another-class",
        "self.create_timer(...)",
    ),
    "of_the_clock": (in_callback("self.now()"), "error.method-of-another-class", "self.get_clock().now"),
    "none": (in_callback("None.publish(String())"), "error.value-is-none", "the line that sets"),
    "number": (in_callback("print((1.0).data)"), "error.value-of-other-kind", "leave out .data"),
    "function": (in_callback("self.get_logger.info('a')"), "error.function-not-called", "parentheses"),
    "overwritten": (
        in_constructor("self._timers = {}; self.create_timer(1.0, self.tick)"),
        "error.private-name-taken",
        "another name",
    ),
    "overwritten_later": (
        in_constructor("self.create_timer(1.0, self.tick); self._timers = {'a': 1}"),
        "error.private-name-taken",
        "another name",
    ),
    "keyword": (
        in_constructor("self.create_timer(timer_period=1.0, callback=self.tick)"),
        "error.keyword-unknown",
        "one of these names",
    ),
    "future": (
        in_callback("rclpy.task.Future().success"),
        "error.result-not-taken",
        "future.result().success",
    ),
    "counts_without_a_start": (in_callback("self.zebra += 1"), "error.no-such-attribute", "in __init__"),
    "nothing_alike": (in_callback("self.zebra()"), "error.no-such-attribute", "in __init__"),
}


@pytest.fixture(scope="module")
def logs(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    folder = tmp_path_factory.mktemp("names")
    cases = [Case(name, program, "", None, "") for name, (program, _, _) in CASES.items()]
    with lease_domain() as lease, ThreadPoolExecutor(2) as pool:
        found = pool.map(lambda case: run_through_host(case, folder, lease.domain_id), cases)
        return dict(zip(CASES, found, strict=True))


@pytest.mark.parametrize("name", CASES)
def test_the_right_name_is_told(name: str, logs: dict[str, str]) -> None:
    _, cause, advice = CASES[name]
    error = find_error(logs[name], f"{name}.py")
    assert isinstance(error, ProgramError) and error.cause == cause, logs[name]
    assert advice in error.try_this, error


def test_the_line_that_has_not_run_is_named(logs: dict[str, str]) -> None:
    error = find_error(logs["set_later"], "set_later.py")
    assert error is not None and "Line 9 sets it" in error.because


@pytest.mark.parametrize(
    ("line", "cause"),
    [
        (
            "AttributeError: 'Robot' object has no attribute 'creat_timer'. Did you mean: 'create_timer'?",
            MISSPELLED,
        ),
        ("AttributeError: 'Robot' object has no attribute 'creat_timer'", "error.no-such-attribute"),
        ("AttributeError: 'NoneType' object has no attribute 'publish'", "error.value-is-none"),
        ("AttributeError: module 'rclpy' has no attribute 'inti'", "error.module-without-name"),
        ("AttributeError: 'Robot' object has no attribute 'seconds'", "error.no-such-attribute"),
        ("AttributeError: 'Time' object has no attribute 'seconds'", "error.name-of-cpp"),
    ],
)
def test_a_log_without_the_hosts_line_is_explained(line: str, cause: str) -> None:
    log = f'Traceback (most recent call last):\n  File "/a/b.py", line 3, in f\n    x\n{line}\n'
    error = find_error(log, "b.py")
    assert error is not None and error.cause == cause
