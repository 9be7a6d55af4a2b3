"""Each wrong claim of an assistant that a lesson warns about is tried with this course's rclpy.

A test's docstring is the claim in the lesson's words ("What to check in the reply"). test_prompts.py compares them.
"""

import array
import contextlib
import importlib.util
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
import rclpy
import std_msgs
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.context import Context
from rclpy.duration import Duration
from rclpy.exceptions import ROSInterruptException
from rclpy.executors import Executor, ExternalShutdownException, MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.publisher import Publisher
from rclpy.qos import QoSCompatibility, QoSProfile, ReliabilityPolicy, qos_check_compatible
from rclpy.serialization import deserialize_message, serialize_message
from rclpy.subscription import Subscription
from rclpy.timer import Rate
from rclpy.wait_for_message import wait_for_message
from scipy.signal import butter, filtfilt, savgol_filter
from sensor_msgs.msg import Image
from std_msgs.msg import Bool, Float32, Float32MultiArray, String
from std_srvs.srv import Trigger

from tests.programs.support import wait_until
from workbook.models import DeskDetector
from workbook.ros.domains import lease_domain
from workbook.ros.environment import child_environment
from workbook.scenes.desk import DeskCamera
from workbook.scenes.pinhole import Pinhole
from workbook.scenes.tabletop import tabletop

LONGEST_S = 20.0
SHORT_S = 0.3
"""How long to wait for things that never come. A program would wait for the end of it, too."""


@pytest.fixture(scope="module")
def domain() -> Iterator[int]:
    with lease_domain() as lease:
        yield lease.domain_id


@pytest.fixture
def context(domain: int) -> Iterator[Context]:
    one = Context()
    rclpy.init(context=one, domain_id=domain, signal_handler_options=rclpy.SignalHandlerOptions.NO)
    yield one
    one.try_shutdown()


@pytest.fixture
def node(context: Context) -> Iterator[Node]:
    one = Node("robot", context=context, start_parameter_services=False)
    yield one
    one.destroy_node()


@pytest.fixture
def executor(context: Context, node: Node) -> Iterator[SingleThreadedExecutor]:
    one = SingleThreadedExecutor(context=context)
    one.add_node(node)
    yield one
    one.shutdown()


def spin_until(executor: Executor, condition: Callable[[], bool]) -> None:
    deadline = time.monotonic() + LONGEST_S
    while not condition():
        assert time.monotonic() < deadline, "it did not happen"
        executor.spin_once(timeout_sec=0.1)


def spin_aside(executor: Executor) -> threading.Thread:
    """Spin in a thread until the context is shut down."""

    def spin() -> None:
        with contextlib.suppress(ExternalShutdownException, ROSInterruptException):
            executor.spin()

    thread = threading.Thread(target=spin, daemon=True)
    thread.start()
    return thread


def run(domain: int, code: str, **environ: str) -> "subprocess.CompletedProcess[str]":
    """Run a separate program, with rclpy's own signal handlers and without field checks."""
    ours = child_environment(domain)
    ours.pop("ROS_PYTHON_CHECK_FIELDS", None)
    command = [sys.executable, "-c", code]
    return subprocess.run(
        command, env=ours | environ, capture_output=True, text=True, timeout=60, check=False
    )


# 00


def test_start_roscore_first(domain: int, executor: SingleThreadedExecutor, node: Node) -> None:
    """Start `roscore` first"""
    heard: list[str] = []
    node.create_subscription(String, "greeting", lambda msg: heard.append(msg.data), 10)
    other = Context()
    rclpy.init(context=other, domain_id=domain, signal_handler_options=rclpy.SignalHandlerOptions.NO)
    try:
        speaker = Node("speaker", context=other, start_parameter_services=False)
        publisher = speaker.create_publisher(String, "greeting", 10)
        wait_until(lambda: publisher.get_subscription_count() == 1)
        publisher.publish(String(data="hello"))
        spin_until(executor, lambda: heard == ["hello"])
    finally:
        other.try_shutdown()


def test_in_one_process_nodes_share_messages(
    context: Context, executor: SingleThreadedExecutor, node: Node
) -> None:
    """In one process, nodes share messages without copying (`use_intra_process_comms`)"""
    with pytest.raises(TypeError, match="use_intra_process_comms"):
        Node("eye", context=context, use_intra_process_comms=True)
    heard: list[Float32MultiArray] = []
    node.create_subscription(Float32MultiArray, "angles", heard.append, 10)
    publisher = node.create_publisher(Float32MultiArray, "angles", 10)
    sent = Float32MultiArray(data=[0.5])
    spin_until(executor, lambda: publisher.get_subscription_count() == 1)
    publisher.publish(sent)
    spin_until(executor, lambda: bool(heard))
    heard[0].data[0] = 0.25
    assert sent.data[0] == 0.5


# 01


def test_with_rclpy_init(domain: int) -> None:
    """`with rclpy.init():`"""
    ended = run(domain, "import rclpy\nwith rclpy.init():\n    pass")
    assert "TypeError: 'NoneType' object does not support the context manager protocol" in ended.stderr


def test_publish_parked_in_except_keyboardinterrupt(domain: int) -> None:
    """Publishing "parked" in `except KeyboardInterrupt` or `finally`"""
    code = """
import os, signal, time, rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node("arm")
publisher = node.create_publisher(String, "state", 10)
node.create_timer(0.05, lambda: os.kill(os.getpid(), signal.SIGINT))
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    while rclpy.ok():  # rclpy's handler shuts down in another thread, at about this moment
        time.sleep(0.01)
    publisher.publish(String(data="parked"))
"""
    ended = run(domain, code)
    assert ended.returncode == 1
    assert "context is invalid" in ended.stderr


# 02


def test_ros_2_refuses_a_second_node(context: Context, node: Node) -> None:
    """ROS 2 rejects a second node with the same name"""
    second = Node("robot", context=context, start_parameter_services=False)
    assert [node.get_fully_qualified_name(), second.get_fully_qualified_name()] == ["/robot", "/robot"]
    wait_until(lambda: node.get_node_names().count("robot") == 2)
    second.destroy_node()


def test_start_it_with_ns(domain: int) -> None:
    """Start each program with `__ns:=/robot_07`"""
    code = (
        "import sys, rclpy\nrclpy.init(args=sys.argv)\n"
        "print(rclpy.create_node('arm').get_fully_qualified_name())\nrclpy.shutdown()"
    )
    old = run(domain, code.replace("sys.argv)", "['arm', '__ns:=/robot_07'])", 1))
    assert old.stdout.strip() == "/robot_07/arm"
    assert "This syntax is deprecated. Use '--ros-args --remap __ns:=/robot_07' instead." in old.stderr
    new = run(domain, code.replace("sys.argv)", "['arm', '--ros-args', '-r', '__ns:=/robot_07'])", 1))
    assert (new.stdout.strip(), new.stderr) == ("/robot_07/arm", "")


# 03

ARRIVES = """
from rclpy.serialization import deserialize_message, serialize_message
from std_msgs.msg import Float32
{setting}
print(deserialize_message(serialize_message(Float32(data=64)), Float32).data)
"""
SET_LATE = "import os; os.environ['ROS_PYTHON_CHECK_FIELDS'] = '1'"


def test_an_int_in_a_float_field(domain: int) -> None:
    """An int in a float field raises a `TypeError`, or is converted"""
    ended = run(domain, ARRIVES.format(setting=""))
    assert (ended.returncode, ended.stdout.strip()) == (0, "0.0")


def test_set_os_environ(domain: int) -> None:
    """Set `os.environ["ROS_PYTHON_CHECK_FIELDS"] = "1"` in `main()`"""
    ended = run(domain, ARRIVES.format(setting=SET_LATE))
    assert (ended.returncode, ended.stdout.strip()) == (0, "0.0")
    in_time = run(domain, SET_LATE + ARRIVES.format(setting=""))
    assert "The 'data' field must be of type 'float'" in in_time.stderr


# 04


def test_when_the_queue_is_full(executor: SingleThreadedExecutor, node: Node) -> None:
    """When the queue is full, the new message is dropped"""
    heard: list[str] = []
    subscription = node.create_subscription(String, "steps", lambda msg: heard.append(msg.data), 2)
    publisher = node.create_publisher(String, "steps", 10)
    wait_until(lambda: publisher.get_subscription_count() == subscription.get_publisher_count() == 1)
    for number in range(5):
        publisher.publish(String(data=str(number)))
    assert publisher.wait_for_all_acked(Duration(seconds=LONGEST_S))
    spin_until(executor, lambda: "4" in heard)
    assert heard == ["3", "4"]


def test_each_subscription_has_a_thread_of_its_own(executor: SingleThreadedExecutor, node: Node) -> None:
    """Each subscription has its own thread"""
    threads: dict[str, int] = {}
    publishers = []
    for topic in ("left", "right"):

        def note(_: Bool, topic: str = topic) -> None:
            threads[topic] = threading.get_ident()

        node.create_subscription(Bool, topic, note, 10)
        publishers.append(node.create_publisher(Bool, topic, 10))
    wait_until(lambda: all(one.get_subscription_count() == 1 for one in publishers))
    for one in publishers:
        one.publish(Bool(data=True))
    spin_until(executor, lambda: len(threads) == 2)
    assert set(threads.values()) == {threading.get_ident()}


# 05


def test_missed_ticks_come_later(executor: SingleThreadedExecutor, node: Node) -> None:
    """Missed ticks come later, in a burst"""
    ticks: list[float] = []
    period_s, work_s = 0.05, 0.5

    def tick() -> None:
        ticks.append(time.monotonic())
        if len(ticks) == 1:
            time.sleep(work_s)

    node.create_timer(period_s, tick)
    spin_until(executor, lambda: bool(ticks) and time.monotonic() - ticks[0] >= work_s + 2 * period_s)
    assert len(ticks) < work_s / period_s  # if missed ticks came later, there would be ten


def test_use_a_rate(node: Node, context: Context) -> None:
    """You can keep the rate by calling `rate.sleep()` in the callback"""
    rates: list[Rate] = []
    began, woke = threading.Event(), threading.Event()

    def callback() -> None:
        rates.append(
            node.create_rate(20)
        )  # otherwise, a tick before the first sleep would make it return immediately
        began.set()
        rates[-1].sleep()
        woke.set()

    node.create_timer(0.01, callback)
    own = SingleThreadedExecutor(context=context)
    own.add_node(node)
    thread = spin_aside(own)
    assert began.wait(LONGEST_S)
    assert not woke.wait(1.0)  # twenty periods
    rates[0].destroy()  # releases the sleeping thread, for the sake of later tests
    context.try_shutdown()
    thread.join(LONGEST_S)


# 06


def test_rclpy_spin_some() -> None:
    """`rclpy.spin_some(node)`"""
    assert not hasattr(rclpy, "spin_some")
    assert not hasattr(SingleThreadedExecutor, "spin_some")
    assert hasattr(rclpy, "spin_once")


def test_spin_once_handles_everything_that_waits(executor: SingleThreadedExecutor, node: Node) -> None:
    """`spin_once(node, timeout_sec=0)` handles everything that's waiting"""
    heard: list[str] = []
    node.create_subscription(String, "steps", lambda msg: heard.append(msg.data), 10)
    publisher = node.create_publisher(String, "steps", 10)
    wait_until(lambda: publisher.get_subscription_count() == 1)
    for number in range(5):
        publisher.publish(String(data=str(number)))
    assert publisher.wait_for_all_acked(Duration(seconds=LONGEST_S))
    for number in range(1, 6):
        spin_until(executor, lambda: bool(heard))
        assert heard == [str(number - 1)]
        heard.clear()


# 07


def test_self_level_publisher_float32() -> None:
    """`self.level: Publisher[Float32] = …`"""
    with pytest.raises(TypeError, match="not subscriptable"):
        Publisher[Float32]


def test_mypy_will_find_the_misspelled_field() -> None:
    """mypy will find the misspelled field `msg.dta`"""
    assert not Path(next(iter(std_msgs.__path__)), "py.typed").exists()


# 08


def test_finally_destroy_and_shutdown(domain: int) -> None:
    """`finally: node.destroy_node(); rclpy.shutdown()`"""
    code = """
import os, signal, time, rclpy
rclpy.init()
node = rclpy.create_node("heart")
node.create_timer(0.05, lambda: os.kill(os.getpid(), signal.SIGINT))
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    pass
finally:
    node.destroy_node()
    while rclpy.ok():  # a thread of rclpy handles the signal, and may be late on a busy machine
        time.sleep(0.01)
    rclpy.shutdown()
"""
    ended = run(domain, code)
    assert ended.returncode == 1
    assert "rcl_shutdown already called" in ended.stderr
    assert run(domain, code.replace("rclpy.shutdown()", "rclpy.try_shutdown()")).returncode == 0


def test_create_publisher_with_queue_size(node: Node) -> None:
    """`create_publisher(String, "status", queue_size=10)`"""
    with pytest.raises(TypeError, match="queue_size"):
        node.create_publisher(String, "status", queue_size=10)
    with pytest.raises(TypeError, match="qos_profile"):
        node.create_publisher(String, "status")


# 09


def test_fill_in_layout_dim() -> None:
    """Fill in `layout.dim`, or no subscriber can read `data`"""
    angles = [0.5, 0.25] * 6
    message = Float32MultiArray(data=angles)
    assert list(message.layout.dim) == []
    assert list(deserialize_message(serialize_message(message), Float32MultiArray).data) == angles


def test_assign_the_table() -> None:
    """Assign a 4 × 3 NumPy array of the angles to `data`"""
    table = np.zeros((4, 3))
    with pytest.raises(TypeError):
        Float32MultiArray(data=table)
    assert Float32MultiArray(data=table.ravel()).data == array.array("f", [0.0] * 12)


# 10


def test_replace_the_executor(context: Context, node: Node) -> None:
    """Replacing the executor with a `MultiThreadedExecutor` is enough"""
    waits, beats = threading.Event(), [0]
    planning = threading.Event()
    planner_of_its_own: list[bool] = []

    def plan() -> None:
        planning.set()
        planner_of_its_own.append(waits.wait(SHORT_S))

    def beat() -> None:
        beats[0] += 1
        if planning.is_set():
            waits.set()

    planner = node.create_timer(0.01, plan)
    node.create_timer(0.01, beat)
    own = MultiThreadedExecutor(num_threads=2, context=context)
    own.add_node(node)
    spin_until(own, lambda: bool(planner_of_its_own))
    assert planner_of_its_own[0] is False, "the heartbeat came while the planner was at work"
    node.destroy_timer(planner)
    waits.clear()
    planning.clear()
    planner_of_its_own.clear()
    node.create_timer(0.01, plan, callback_group=MutuallyExclusiveCallbackGroup())
    spin_until(own, lambda: True in planner_of_its_own)
    own.shutdown()


def test_the_executor_logs_an_exception(executor: SingleThreadedExecutor, node: Node) -> None:
    """The executor logs an exception in a callback and continues"""

    def plan() -> None:
        raise ValueError("no path")

    node.create_timer(0.01, plan)
    with pytest.raises(ValueError, match="no path"):
        executor.spin()


# 11


def test_subscription_take() -> None:
    """`subscription.take()`"""
    assert not hasattr(Subscription, "take")


def test_wait_for_message(context: Context, node: Node) -> None:
    """`wait_for_message("/bumper", Bool, timeout=1.0)`"""
    with pytest.raises(TypeError):
        wait_for_message("/bumper", Bool, timeout=1.0)
    assert wait_for_message(Bool, node, "/bumper", time_to_wait=0.01) == (False, None)
    publisher = node.create_publisher(Bool, "/bumper", 1)
    over = threading.Event()

    def press() -> None:
        while not over.wait(0.02):
            publisher.publish(Bool(data=True))

    thread = threading.Thread(target=press)
    thread.start()
    try:
        assert wait_for_message(Bool, node, "/bumper", time_to_wait=LONGEST_S) == (True, Bool(data=True))
    finally:
        over.set()
        thread.join()


# 12


def ask_while_spinning(executor: SingleThreadedExecutor, node: Node, ask: Callable[[], object]) -> None:
    """Call `ask` once, in a callback of the node's default group."""
    asked = threading.Event()

    async def once() -> None:
        timer.cancel()
        answer = ask()
        asked.set()
        if hasattr(answer, "__await__"):
            await answer

    timer = node.create_timer(0.01, once)
    spin_until(executor, asked.is_set)


@pytest.fixture
def arms(domain: int) -> Iterator[None]:
    """Start a server that responds immediately, in a separate thread."""
    other = Context()
    rclpy.init(context=other, domain_id=domain, signal_handler_options=rclpy.SignalHandlerOptions.NO)
    server = Node("arms", context=other, start_parameter_services=False)
    server.create_service(Trigger, "stretch_out", lambda request, response: response)
    own = SingleThreadedExecutor(context=other)
    own.add_node(server)
    thread = spin_aside(own)
    yield
    other.try_shutdown()
    thread.join(LONGEST_S)


@pytest.mark.usefixtures("arms")
def test_await_is_safe_in_any_callback(executor: SingleThreadedExecutor, node: Node) -> None:
    """`await client.call_async()` is safe in any callback"""
    client = node.create_client(Trigger, "stretch_out")
    apart = node.create_client(Trigger, "stretch_out", callback_group=MutuallyExclusiveCallbackGroup())
    for one in (client, apart):
        wait_until(one.service_is_ready)
    futures = []

    def ask(one: object) -> object:
        futures.append(one.call_async(Trigger.Request()))
        return futures[-1]

    ask_while_spinning(executor, node, lambda: ask(client))
    later = apart.call_async(Trigger.Request())
    spin_until(executor, later.done)
    assert not futures[0].done()


@pytest.mark.usefixtures("arms")
def test_spin_until_future_complete_in_the_callback(executor: SingleThreadedExecutor, node: Node) -> None:
    """Call `rclpy.spin_until_future_complete(node, future)` in the callback"""
    client = node.create_client(Trigger, "stretch_out")
    wait_until(client.service_is_ready)
    done: list[bool] = []

    def ask() -> None:
        future = client.call_async(Trigger.Request())
        rclpy.spin_until_future_complete(node, future, executor=executor, timeout_sec=SHORT_S)
        done.append(future.done())

    ask_while_spinning(executor, node, ask)
    assert done == [False]


# 13


def test_qosprofile_with_seconds() -> None:
    """`QoSProfile(depth=10, deadline=0.1)`"""
    with pytest.raises(AssertionError):
        QoSProfile(depth=10, deadline=0.1)
    assert QoSProfile(depth=10, deadline=Duration(seconds=0.1)).deadline == Duration(seconds=0.1)


def test_a_best_effort_subscriber() -> None:
    """A best-effort subscription doesn't match a reliable publisher"""
    reliable = QoSProfile(depth=10, reliability=ReliabilityPolicy.RELIABLE)
    best_effort = QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT)
    assert qos_check_compatible(reliable, best_effort)[0] != QoSCompatibility.ERROR
    assert qos_check_compatible(best_effort, reliable)[0] == QoSCompatibility.ERROR


# 14


def test_filtfilt_in_the_callback() -> None:
    """Call `filtfilt` in the callback"""

    samples = np.random.default_rng(14).normal(size=60).cumsum()
    b, a = butter(2, 0.2)
    now, a_message_later = filtfilt(b, a, samples[:-1]), filtfilt(b, a, samples)
    assert now[-1] != pytest.approx(a_message_later[-2])


def test_savgol_filter_on_the_last_samples() -> None:
    """Call `savgol_filter` on the last samples, because it has no delay"""
    samples = np.random.default_rng(14).normal(size=60).cumsum()
    now, a_message_later = savgol_filter(samples[:-1], 19, 1), savgol_filter(samples, 19, 1)
    assert now[-1] != pytest.approx(a_message_later[-2])


# 15


def test_cv_bridge() -> None:
    """`from cv_bridge import CvBridge`"""
    assert importlib.util.find_spec("cv_bridge") is None


def test_reshape_without_step() -> None:
    """`np.array(msg.data).reshape(height, width, 3)`"""
    height, width, padding = 2, 3, 3
    rows = np.zeros((height, 3 * width + padding), np.uint8)
    image = Image(height=height, width=width, encoding="bgr8", step=rows.shape[1], data=rows.tobytes())
    with pytest.raises(ValueError, match="cannot reshape"):
        np.array(image.data).reshape(height, width, 3)
    table = np.frombuffer(image.data, np.uint8).reshape(height, image.step)
    assert table[:, : 3 * width].reshape(height, width, 3).shape == (2, 3, 3)


# 16


def test_a_subscription_with_a_plain_ten() -> None:
    """`create_subscription(Image, "/camera/image", self.on_image, 10)`"""
    camera = QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT)
    plain_ten = QoSProfile(depth=10)  # rclpy's QoS profile for the number
    assert plain_ten.reliability == ReliabilityPolicy.RELIABLE
    assert qos_check_compatible(camera, plain_ten)[0] == QoSCompatibility.ERROR


def test_bgr_for_a_network_that_knows_rgb() -> None:
    """`CvBridge().imgmsg_to_cv2(msg, "bgr8")`, then the network"""
    pinhole = Pinhole(320, 240, 280.0)
    rgb = DeskCamera(pinhole, 16).picture(tabletop(16, 0), 0)
    detector = DeskDetector()
    labels, swapped = ({one.label for one in detector(picture)} for picture in (rgb, rgb[:, :, ::-1].copy()))
    assert labels
    assert swapped != labels
