"""What the judge does with a program: publish, offer services, call services and functions, and find leftovers."""

import math
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest
import rclpy
from rclpy.context import Context
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions
from std_msgs.msg import Float32, String
from std_srvs.srv import SetBool, Trigger

from tests.lesson_nodes.ending import ended_in_order
from workbook.criteria.vocabulary.pairing import script
from workbook.programs.spec import ProgramSpec
from workbook.recording.plan import Plan
from workbook.recording.recording import Clock, Recording
from workbook.recording.script import BEFORE_START, Part, Script, calls, publish, serves
from workbook.ros.environment import LOOPBACK_PROFILE, profile_with_default_times, profile_with_lease
from workbook.watching.observer import Observer
from workbook.watching.recorder import Recorder
from workbook.watching.script_player import SERVED_EVERY_S, ScriptPlayer
from workbook.watching.watch import Watch

HEAD = """
import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import Float32, String
from std_srvs.srv import SetBool, Trigger
"""
SPIN = """
rclpy.init()
try:
    rclpy.spin(Robot())
except KeyboardInterrupt:
    pass
rclpy.try_shutdown()
"""
ECHO = (
    HEAD
    + """
class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        self.echo = self.create_publisher(Float32, "/robot/echo", 100)
        self.create_subscription(Float32, "/robot/level", self.echo.publish, 100)
"""
    + SPIN
)
LATER_S = 0.3
TRIES = 3
HANDED_OVER_S = 1.0  # earlier messages are delivered shortly after the match
LEVELS = tuple(float(number) for number in range(20))


@pytest.fixture(scope="module")
def observer() -> Iterator[Observer]:
    with Observer() as one:
        yield one


def watch(
    observer: Observer,
    folder: Path,
    code: str,
    *parts: Part,
    topics: tuple[str, ...] = (),
    clock: Clock = "wall",
    seconds: float = 1.5,
    driver: str | None = None,
) -> Recording:
    program = folder / "program.py"
    program.write_text(code)
    plan = Plan(topics, 0.1, 1.0, seconds, seconds, Script(parts), to_the_end=True)
    file = None
    if driver is not None:
        file = folder / "driver.py"
        file.write_text(driver)
    with Watch(observer, ProgramSpec(program, driver=file), plan, clock) as one:
        return one.finish(one.observe(), 4.0, look_who_stays=True)


@pytest.mark.parametrize("clock", ["wall", "simulated"])
def test_what_is_said_comes_back_in_order(observer: Observer, tmp_path: Path, clock: Clock) -> None:
    lines = [(0.05 * number, level) for number, level in enumerate(LEVELS)]
    recording = watch(
        observer,
        tmp_path,
        ECHO,
        publish("/robot/level", Float32, lines),
        topics=("/robot/echo",),
        clock=clock,
    )
    assert [one.value["data"] for one in recording.published] == list(LEVELS)
    assert [one.value["data"] for one in recording.topic("/robot/echo").arrivals] == list(LEVELS)
    assert [round(one.t, 2) for one in recording.published[:3]] == pytest.approx([0.0, 0.05, 0.1], abs=0.1)


DIES_AFTER_THREE = ECHO.replace(
    "self.echo.publish, 100)",
    """self.hear, 100)
        self.heard = 0
    def hear(self, message):
        self.heard += 1
        if self.heard == 3:
            raise ValueError("three is enough")""",
)


@pytest.mark.parametrize("clock", ["wall", "simulated"])
def test_what_a_program_did_not_live_to_hear_is_in_its_recording(
    observer: Observer, tmp_path: Path, clock: Clock
) -> None:
    part = publish("/robot/level", Float32, [(0.1 * number, level) for number, level in enumerate(LEVELS)])
    recording = watch(observer, tmp_path, DIES_AFTER_THREE, part, clock=clock, seconds=3.0)
    assert 3 <= len(recording.published) < len(LEVELS)
    assert [one.value["data"] for one in script(recording, part.topic)] == list(LEVELS)


SLOW_STARTER = (
    HEAD
    + """
import time

class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        busy_until = time.monotonic() + 1.2
        while time.monotonic() < busy_until:
            pass
        self.echo = self.create_publisher(Float32, "/robot/echo", 100)
        self.create_subscription(Float32, "/robot/level", self.echo.publish, 100)
"""
    + SPIN
)


def test_a_program_that_is_still_at_work_is_waited_for(observer: Observer, tmp_path: Path) -> None:
    lines = [(0.05 * number, level) for number, level in enumerate(LEVELS)]
    recording = watch(
        observer,
        tmp_path,
        SLOW_STARTER,
        publish("/robot/level", Float32, lines),
        publish("/other_robot/level", Float32, [(0.0, 1.0)], awaited=False),
        topics=("/robot/echo",),
    )
    assert [one.value["data"] for one in recording.topic("/robot/echo").arrivals] == list(LEVELS)


@pytest.fixture
def bench(observer: Observer) -> Iterator[Node]:
    context = Context()
    rclpy.init(context=context, domain_id=observer.domain_id, signal_handler_options=SignalHandlerOptions.NO)
    try:
        node = Node("judge", context=context)
        yield node
        node.destroy_node()
    finally:
        rclpy.shutdown(context=context)


def test_a_node_whose_name_comes_after_its_publisher_is_waited_for(
    observer: Observer, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The judge's next message may end the node, and then its name would stay unknown."""
    known = Recorder.present
    published: list[float] = []

    def known_later(recorder: Recorder) -> Counter[str]:
        if recorder.any_publisher():
            published.append(time.monotonic())
        return known(recorder) if published and time.monotonic() - published[0] > LATER_S else Counter()

    monkeypatch.setattr(Recorder, "present", known_later)
    fragile = ECHO.replace("self.echo.publish", "lambda level: self.show(level)")  # there is no such method
    level = publish("/robot/level", Float32, [(0.0, 1.0)])
    recording = watch(observer, tmp_path, fragile, level, topics=("/robot/echo",))
    assert recording.process.ended_by == "itself"
    assert [node.name for node in recording.nodes] == ["/robot"]


def test_what_is_not_awaited_holds_nothing_up(bench: Node) -> None:
    for awaited in (True, False):
        script = Script((publish("/other_robot/level", Float32, [(0.0, 2.0)], awaited=awaited),))
        assert ScriptPlayer(bench, script, lambda moment: moment).ready() is not awaited


def test_the_next_line_of_all_parts_is_what_is_waited_for(bench: Node) -> None:
    level = publish("/robot/level", Float32, [(BEFORE_START, 0.0), (1.0, 1.0), (3.0, 2.0)])
    player = ScriptPlayer(
        bench, Script((level, publish("/robot/word", String, [(2.0, "stop")]))), lambda moment: moment
    )
    assert player.until_next(0.25) == 0.75
    player.play(1.0)
    assert player.until_next(1.0) == 1.0
    player.play(2.5)
    assert player.until_next(2.5) == 0.5
    assert player.until_next(3.5) == 0.0
    player.play(3.5)
    assert player.until_next(3.5) == math.inf


def test_lines_that_come_late_keep_their_pauses_where_nobody_can_stop_the_clock(bench: Node) -> None:
    lines = [(1.0, 1.0), (1.1, 2.0), (1.1, 3.0), (1.2, 4.0)]
    player = ScriptPlayer(bench, Script((publish("/robot/level", Float32, lines),)), lambda moment: moment)
    said: list[list[float]] = []
    for moment in (0.99, 1.005, 1.5, 1.59, 1.61):  # held up from 1.005 s to 1.5 s
        before = len(player.published())
        player.play(moment, keep_pauses=True)
        said.append([line.value["data"] for line in player.published()[before:]])
    assert said == [[], [1.0], [2.0, 3.0], [], [4.0]]
    assert player.late_s == pytest.approx(0.4)


def test_the_parts_of_a_script_share_one_delay(bench: Node) -> None:
    """If the judge is held up while only one part is due, both parts are delayed."""
    images = publish("/robot/level", Float32, [(1.0, 10.0), (2.0, 20.0), (3.0, 30.0)])
    samples = publish("/robot/other", Float32, [(1.5, 15.0), (2.5, 25.0)])
    player = ScriptPlayer(bench, Script((samples, images)), lambda moment: moment)
    said: list[list[float]] = []
    for moment in (1.9, 2.39, 2.41, 2.91, 3.41, 3.91):  # held up until 1.9 s, when both first lines are due
        before = len(player.published())
        player.play(moment, keep_pauses=True)
        said.append([line.value["data"] for line in player.published()[before:]])
    assert said == [[10.0], [], [15.0], [20.0], [25.0], [30.0]]
    assert player.late_s == pytest.approx(0.9)


def test_on_simulated_time_all_that_is_due_is_said(bench: Node) -> None:
    script = Script((publish("/robot/level", Float32, [(1.0, 1.0), (1.1, 2.0), (1.2, 3.0)]),))
    player = ScriptPlayer(bench, script, lambda moment: moment)
    player.play(1.15)
    assert [line.value["data"] for line in player.published()] == [1.0, 2.0]


@pytest.mark.parametrize(
    "part", [serves("/robot/reset", Trigger, [({}, 0.0)]), calls("/robot/reset", Trigger, [])]
)
def test_whoever_calls_or_is_called_may_come_at_any_moment(bench: Node, part: Part) -> None:
    assert ScriptPlayer(bench, Script((part,)), lambda moment: moment).until_next(0.0) == SERVED_EVERY_S


LATE = (
    HEAD
    + """
class Robot(Node):
    def __init__(self):
        super().__init__("dashboard")
        self.shown = self.create_publisher(String, "/dashboard/line", 10)
        self.last = "nothing"
        keep = QoSProfile(depth=1, durability=DurabilityPolicy.%s)
        self.create_subscription(String, "/robot/status", self.hear, keep)
        self.create_timer(0.1, lambda: self.shown.publish(String(data=self.last)))

    def hear(self, message):
        self.last = message.data
"""
    + SPIN
)


@pytest.mark.parametrize(("durability", "shown"), [("TRANSIENT_LOCAL", "standing"), ("VOLATILE", "nothing")])
def test_what_was_said_before_the_start_reaches_those_who_ask_for_it(
    observer: Observer, tmp_path: Path, durability: str, shown: str
) -> None:
    status = publish("/robot/status", String, [(BEFORE_START, "standing")], qos="latched")
    recording = watch(observer, tmp_path, LATE % durability, status, topics=("/dashboard/line",), seconds=2.0)
    arrivals = recording.topic("/dashboard/line").arrivals
    assert {one.value["data"] for one in arrivals if one.t > HANDED_OVER_S} == {shown}
    assert recording.published[0].t == BEFORE_START


CLIENT = (
    HEAD
    + """
class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        self.heard = self.create_publisher(String, "/robot/heard", 10)
        self.self_test = self.create_client(Trigger, "/robot/self_test")
        self.create_timer(0.2, self.ask)

    def ask(self):
        future = self.self_test.call_async(Trigger.Request())
        future.add_done_callback(lambda done: self.heard.publish(String(data=done.result().message)))
"""
    + SPIN
)


def test_a_service_is_offered_late_and_never(observer: Observer, tmp_path: Path) -> None:
    replies = [({"success": True, "message": "fine"}, 0.0), ({"message": "slow"}, 0.3), ({}, None)]
    recording = watch(observer, tmp_path, CLIENT, serves("/robot/self_test", Trigger, replies))
    taken = [
        None if call.answered_wall is None else call.answered_wall - call.wall for call in recording.calls
    ]
    assert len(taken) >= 3
    assert taken[0] is not None and taken[1] is not None
    assert taken[1] - taken[0] > 0.2
    assert set(taken[2:]) == {None}
    heard = {one.value["data"] for one in recording.topic("/robot/heard").arrivals}
    assert "slow" in heard
    assert recording.calls[0].by == "program"
    assert recording.calls[0].response == {"success": True, "message": "fine"}
    assert [(one.name, one.type) for one in recording.clients] == [
        ("/robot/self_test", "std_srvs/srv/Trigger")
    ]
    assert recording.services == ()


SERVER = (
    HEAD
    + """
class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        self.create_service(SetBool, "/robot/power", self.switch)

    def switch(self, request, response):
        response.message = "on" if request.data else "off"
        return response
"""
    + SPIN
)


def test_a_service_of_the_program_is_called(observer: Observer, tmp_path: Path) -> None:
    script = calls("/robot/power", SetBool, [(0.1, {"data": True}), (0.2, {"data": False})])
    recording = watch(observer, tmp_path, SERVER, script, seconds=0.8)
    assert [call.response["message"] for call in recording.calls if call.response] == ["on", "off"]
    assert [(one.name, one.type) for one in recording.services] == [("/robot/power", "std_srvs/srv/SetBool")]


FUNCTION = """
def double(level):
    return 2.0 * level
"""
DRIVER = (
    HEAD
    + """
import answer
rclpy.init()
node = Node("driver")
results = node.create_publisher(Float32, "/driver/result", 100)
node.create_subscription(Float32, "/driver/level", lambda m: results.publish(Float32(data=answer.double(m.data))), 100)
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    pass
rclpy.try_shutdown()
"""
)


def test_a_driver_calls_a_function_in_the_process_of_the_answer(observer: Observer, tmp_path: Path) -> None:
    lines = [(0.1, 1.5), (0.2, 4.0)]
    recording = watch(
        observer,
        tmp_path,
        FUNCTION,
        publish("/driver/level", Float32, lines),
        topics=("/driver/result",),
        seconds=0.6,
        driver=DRIVER,
    )
    assert [one.value["data"] for one in recording.topic("/driver/result").arrivals] == [3.0, 8.0]


def test_an_error_in_the_answer_is_told_although_a_driver_imports_it(
    observer: Observer, tmp_path: Path
) -> None:
    recording = watch(observer, tmp_path, "level = 1 / 0\n", topics=("/driver/result",), driver=DRIVER)
    assert recording.process.ended_by == "itself"
    assert "ZeroDivisionError" in recording.process.log
    assert 'program.py", line 1' in recording.process.log


TWINS = (
    HEAD
    + """
import os, signal
rclpy.init()
nodes = [Node("arm"), Node("arm"), Node("head", namespace="/robot")]
%s
try:
    while True:
        rclpy.spin_once(nodes[2], timeout_sec=0.1)
except KeyboardInterrupt:
    pass
rclpy.try_shutdown()
"""
)


def test_twins_are_counted_and_a_clean_end_leaves_no_node(observer: Observer, tmp_path: Path) -> None:
    """On a very busy machine, DDS may lose a goodbye message, which isn't repeated: about one in a hundred ends."""
    for _ in range(TRIES):
        recording = watch(observer, tmp_path, TWINS % "", seconds=0.5)
        assert {node.name: node.most for node in recording.nodes} == {"/arm": 2, "/robot/head": 1}
        assert ended_in_order(recording.process.exit, recording.process.end_log), recording.process
        if not any(node.stayed for node in recording.nodes):
            break
    assert {node.stayed for node in recording.nodes} == {False}


def test_a_program_that_cuts_itself_off_leaves_its_node_behind(observer: Observer, tmp_path: Path) -> None:
    cut_off = "signal.signal(signal.SIGINT, lambda *_: os._exit(0))"
    haunted = observer.domain_id
    recording = watch(observer, tmp_path, TWINS % cut_off, seconds=0.5)
    assert {node.stayed for node in recording.nodes} == {True}
    assert recording.process.exit == 0
    assert observer.domain_id != haunted
    after = watch(observer, tmp_path, TWINS % "", seconds=0.5)
    assert {node.name: node.most for node in after.nodes} == {"/arm": 2, "/robot/head": 1}


def test_a_profile_with_another_lease_differs_in_the_lease_alone(tmp_path: Path) -> None:
    usual, lingering = LOOPBACK_PROFILE.read_text(), profile_with_lease(tmp_path, 20).read_text()
    assert "<leaseDuration><sec>20</sec></leaseDuration>" in lingering
    assert lingering.replace("<sec>20</sec>", "<sec>2</sec>") == usual


def test_a_profile_with_the_default_times_differs_in_the_discovery_alone(tmp_path: Path) -> None:
    usual, default = (path.read_text() for path in (LOOPBACK_PROFILE, profile_with_default_times(tmp_path)))
    before, after = usual.split("<discovery_config>")
    assert default.split() == (before + after.split("</discovery_config>")[1]).split()


def test_processor_time_is_sampled_and_everything_survives_storage(
    observer: Observer, tmp_path: Path
) -> None:
    lines = [(0.1, 1.0)]
    recording = watch(
        observer, tmp_path, ECHO, publish("/robot/level", Float32, lines), topics=("/robot/echo",)
    )
    samples = recording.process.processor
    assert len(samples) >= 5
    assert all(a[0] < b[0] and a[1] <= b[1] for a, b in zip(samples, samples[1:], strict=False))
    recording.save(tmp_path / "recording.json")
    assert Recording.load(tmp_path / "recording.json") == recording


WATCHFUL = (
    HEAD
    + """
from rclpy.duration import Duration
from rclpy.event_handler import SubscriptionEventCallbacks

class Robot(Node):
    def __init__(self):
        super().__init__("watchdog")
        self.late = self.create_publisher(String, "/watchdog/late", 10)
        missed = SubscriptionEventCallbacks(deadline=lambda event: self.late.publish(String(data="late")))
        qos = QoSProfile(depth=10, deadline=Duration(seconds=0.5))
        self.create_subscription(Float32, "/robot/level", lambda message: None, qos, event_callbacks=missed)
"""
    + SPIN
)


@pytest.mark.parametrize(("offered", "misses"), [(0.25, True), (None, False)])
def test_a_deadline_can_be_requested_where_one_is_offered(
    observer: Observer, tmp_path: Path, offered: float | None, misses: bool
) -> None:
    level = publish("/robot/level", Float32, [(0.0, 1.0)], deadline=offered)
    recording = watch(observer, tmp_path, WATCHFUL, level, topics=("/watchdog/late",), seconds=1.5)
    assert bool(recording.topic("/watchdog/late").arrivals) is misses
    assert [one.deadline for one in recording.topic("/robot/level").subscribers] == [0.5]
    assert [one.deadline for one in recording.topic("/watchdog/late").publishers] == [None]


@pytest.mark.parametrize("deadline", [0.0, -1.0, float("nan")])
def test_an_offered_deadline_is_above_zero(deadline: float) -> None:
    with pytest.raises(ValueError, match="above zero"):
        publish("/robot/level", Float32, [], deadline=deadline)


def test_calls_without_end_are_not_all_kept(bench: Node, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("workbook.watching.script_player.CALLS_KEPT", 3)
    player = ScriptPlayer(
        bench, Script((serves("/robot/self_test", Trigger, [({}, 0.0)]),)), lambda moment: moment
    )
    client = bench.create_client(Trigger, "/robot/self_test")
    assert client.wait_for_service(20.0)
    answered = 0
    for _ in range(5):
        with client.handle:
            client.handle.send_request(Trigger.Request())
    deadline = time.monotonic() + 20.0
    while answered < 3 and time.monotonic() < deadline:
        player.poll()
        with client.handle:
            answered += client.handle.take_response(Trigger.Response)[0] is not None
    player.poll()
    assert answered == 3
    assert [call.answered_t is not None for call in player.calls()] == [True] * 3
