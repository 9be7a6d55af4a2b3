"""rclpy's terse errors, values that don't fit their field, and names from another ROS: each is explained live."""

import re
from concurrent.futures import ThreadPoolExecutor

import pytest

from tests.criteria.test_known_errors import IN_NODE, Case, run_through_host
from workbook.criteria.vocabulary.error_table_of_calls import ERRORS_OF_CALLS
from workbook.criteria.vocabulary.foreign_names import foreign_name
from workbook.criteria.vocabulary.known_errors import find_error
from workbook.criteria.vocabulary.names_elsewhere import name_elsewhere
from workbook.ros.domains import lease_domain

IMPORTS = """\
import asyncio
from geometry_msgs.msg import Twist
from std_msgs.msg import Header, Int32
from rclpy.duration import Duration
from rclpy.qos import QoSProfile
from std_srvs.srv import Trigger
"""
SENDS = "self.create_publisher({0}, 'x', 10).publish({0}({1}))"
CASES = {
    "error.qos-as-words": "QoSProfile(depth=1, durability='transient_local')",
    "error.qos-duration": "QoSProfile(depth=1, lifespan=0.3)",
    "error.qos-depth": "QoSProfile(depth='10')",
    "error.qos-keyword": "QoSProfile(depth=1, durable=True)",
    "error.qos-without-depth": "QoSProfile(10)",
    "error.qos-not-a-profile": "self.create_publisher(String, 'x', 'best_effort')",
    "error.logger-takes-text": "self.get_logger().info(5)",
    "error.timer-once": "self.create_timer(1.0, self.tick, oneshot=True)",
    "error.qos-setting-alone": "self.create_publisher(String, 'x', reliability='best_effort')",
    "error.ros-1-keyword": "self.create_publisher(String, 'x', queue_size=10)",
    "error.no-event-loop": "self.create_timer(0.01, lambda: asyncio.get_running_loop())",
    "error.timer-period": "self.create_timer(0.2 - 0.4, self.tick)",
    "error.timer-arguments-swapped": "self.create_timer(self.tick, 1.0)",
    "error.topic-name-none": "self.create_publisher(String, None, 10)",
    "error.parameter-not-declared": "self.get_parameter('speed')",
    "error.parameter-declared-twice": "[self.declare_parameter('a', 1) for _ in range(2)]",
    "error.spin-on-no-node": "rclpy.spin('humanoid')",
    "error.nothing-to-spin": "rclpy.spin()",
    "error.executor-attribute": "self.executor = 5",
    "error.service-itself": "Trigger()",
    "error.no-request": "self.create_client(Trigger, 'x').call_async(Trigger)",
    "error.no-response": "self.create_service(Trigger, 'x', print).send_response(None, None)",
    "error.time-without-to-msg": "self.get_clock().now().sec",
    "error.time-minus-number": "self.get_clock().now() - 1.0",
    "error.duration-by-position": "Duration(1.0)",
    "error.field-by-position": "Float32(1.0)",
    "error.unknown-field": "Twist().linear.speed = 1.0",
    "error.wrong-value-type": SENDS.format("String", "data={}"),
    "error.name-of-ros-1": "rclpy.Rate(10)",
    "error.name-of-cpp": "self.create_wall_timer(1.0, self.tick)",
    "error.name-in-other-module": "from std_msgs.msg import Twist",
    "error.module-of-ros-1": "import rospy",
    "error.module-not-installed": "from cv_bridge import CvBridge",
}
OTHER_CASES = {"error.name-of-cpp of a time": "self.get_clock().now().seconds"}


@pytest.fixture(scope="module")
def logs(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    folder = tmp_path_factory.mktemp("calls")
    cases = [
        Case(re.sub(r"\W", "_", cause), IMPORTS + IN_NODE.format(body=body), "", None, "")
        for cause, body in (CASES | OTHER_CASES).items()
    ]
    with lease_domain() as lease, ThreadPoolExecutor(2) as pool:
        found = pool.map(lambda case: run_through_host(case, folder, lease.domain_id), cases)
        return dict(zip(CASES | OTHER_CASES, found, strict=True))


def test_every_row_has_its_case() -> None:
    assert {row.cause for row in ERRORS_OF_CALLS} <= set(CASES)


@pytest.mark.parametrize("cause", CASES)
def test_the_cause_and_the_line_are_named(cause: str, logs: dict[str, str]) -> None:
    error = find_error(logs[cause], f"{re.sub(r'[^a-z0-9_]', '_', cause)}.py")
    assert error is not None and error.cause == cause, logs[cause]
    assert error.line == 15, logs[cause]


def test_a_value_is_named_with_its_field_and_what_it_takes(logs: dict[str, str]) -> None:
    error = find_error(logs["error.wrong-value-type"])
    assert error is not None
    assert (
        error.because
        == "The 'data' field of String has the type string. It was given a value of type dict: {}."
    )
    assert "a string" in error.try_this


def test_the_fields_of_a_message_are_named(logs: dict[str, str]) -> None:
    error = find_error(logs["error.unknown-field"])
    assert error is not None and "Its fields are x, y and z." in error.because


def test_a_comma_that_makes_a_tuple_is_named() -> None:
    log = (
        'Traceback (most recent call last):\n  File "/a/b.py", line 3, in f\n    x\n'
        "AssertionError: The 'data' field must be of type 'float'\n"
        "The field 'data' of Float32 takes float, and got tuple: (92.0,)\n"
    )
    error = find_error(log, "b.py")
    assert error is not None and error.cause == "error.field-of-other-type"
    assert "A comma at the end of a line turns the value into a one-item tuple" in error.because
    assert error.try_this == "Remove the comma after the value."


@pytest.mark.parametrize(
    ("error", "where"),
    [
        ("AttributeError: module 'rclpy' has no attribute 'Node'", "Node is in rclpy.node, not in rclpy."),
        ("ImportError: cannot import name 'String' from 'std_msgs' (/x)", "String is in std_msgs.msg"),
        (
            "ImportError: cannot import name 'Time' from 'std_msgs.msg' (/x)",
            "Time is in builtin_interfaces.msg",
        ),
        ("ModuleNotFoundError: No module named 'std_msgs.srv'", "in std_srvs.srv"),
        ("AttributeError: 'RcutilsLogger' object has no attribute 'loginfo'", "loginfo belongs to ROS 1"),
        ("AttributeError: 'Time' object has no attribute 'to_sec'", "to_sec belongs to ROS 1"),
        ("AttributeError: module 'rclpy' has no attribute 'spin_some'", "belongs to the C++ library"),
    ],
)
def test_where_a_name_is_instead_is_told(error: str, where: str) -> None:
    found = foreign_name(error) or name_elsewhere(error)
    assert found is not None and where in found[1]


@pytest.mark.parametrize(
    "error",
    [
        "AttributeError: 'Robot' object has no attribute 'heart'",
        "ImportError: cannot import name 'Node' from 'my_robot' (/x)",
        "ImportError: cannot import name 'Floaty' from 'std_msgs.msg' (/x)",
    ],
)
def test_other_names_are_nowhere_else(error: str) -> None:
    assert name_elsewhere(error) is None


def test_rclpys_time_is_not_taken_for_the_message(logs: dict[str, str]) -> None:
    """Both classes are named Time, and both are loaded."""
    error = find_error(logs["error.name-of-cpp of a time"])
    assert error is not None and (error.cause, error.try_this) == (
        "error.name-of-cpp",
        "Use nanoseconds / 1e9.",
    )


@pytest.mark.parametrize(
    ("error", "source"),
    [
        ("ModuleNotFoundError: No module named 'tf2_ros'", "full ROS 2 installation"),
        ("ModuleNotFoundError: No module named 'rospy'", "ROS 1"),
        ("ModuleNotFoundError: No module named 'launch_ros.actions'", "build and start"),
        ("ModuleNotFoundError: No module named 'ament_cmake_test'", "build and start"),
        ("ModuleNotFoundError: No module named 'pandas'", "Python package"),
        ("ImportError: cannot import name 'Rate' from 'rclpy' (/x)", "ROS 1"),
        ("ModuleNotFoundError: No module named 'rclpy.rate'", "ROS 1"),
        ("AttributeError: module 'rclpy' has no attribute 'logwarn_throttle'", "ROS 1"),
    ],
)
def test_the_origin_of_a_foreign_name_is_told(error: str, source: str) -> None:
    found = foreign_name(error)
    assert found is not None and source in found[1]


@pytest.mark.parametrize(
    "error",
    [
        "ModuleNotFoundError: No module named 'rclpie'",
        "AttributeError: module 'rclpy' has no attribute 'inti'",
    ],
)
def test_a_name_from_nowhere_has_no_origin(error: str) -> None:
    assert foreign_name(error) is None
