"""Watch real programs: exact simulated time, doubts about other programs, and two observers that don't interfere."""

import threading
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from tests.programs.support import write
from workbook.programs.spec import ProgramSpec
from workbook.recording.plan import SPEEDS, Plan
from workbook.recording.recording import Recording, Stretch
from workbook.ros.domains import lease_domain
from workbook.watching.following import intervals_of, rates_differ
from workbook.watching.observer import Observer
from workbook.watching.recorder import Recorder
from workbook.watching.watch import Watch

TOPICS = ("/battery", "/status")
PLAN = Plan(TOPICS, shortest_period=0.5, longest_period=1.0, paced=TOPICS)
TWO_TIMERS = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String


class Humanoid(Node):
    def __init__(self):
        super().__init__("humanoid", namespace="robot")
        self.level = 100.0
        self.battery_pub = self.create_publisher(Float32, "/battery", 10)
        self.status_pub = self.create_publisher(String, "/status", 10)
        self.create_timer(1.0, self.tell_battery)
        self.create_timer(0.5, self.tell_status)

    def tell_battery(self):
        self.level -= 0.5
        self.battery_pub.publish(Float32(data=self.level))

    def tell_status(self):
        self.status_pub.publish(String(data="operational"))


rclpy.init()
try:
    rclpy.spin(Humanoid())
except (KeyboardInterrupt, rclpy.executors.ExternalShutdownException):
    pass
"""
TIMER_AND_SLEEP = """
import threading, time
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String

rclpy.init()
node = Node("humanoid")
battery, status = node.create_publisher(Float32, "/battery", 10), node.create_publisher(String, "/status", 10)
node.create_timer(1.0, lambda: battery.publish(Float32(data=1.0)))


def tell_status():
    while True:
        status.publish(String(data="operational"))
        time.sleep(0.5)


threading.Thread(target=tell_status, daemon=True).start()
try:
    rclpy.spin(node)
except (KeyboardInterrupt, rclpy.executors.ExternalShutdownException):
    pass
"""
OWN_CLOCK = """
import threading, time
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String

rclpy.init()
node = Node("humanoid"{options})
battery, status = node.create_publisher(Float32, "/battery", 10), node.create_publisher(String, "/status", 10)


def work():
    while True:
        battery.publish(Float32(data=1.0))
        status.publish(String(data="operational"))
        time.sleep(0.02)


threading.Thread(target=work, daemon=True).start()
rclpy.spin(node)
"""


REFUSAL = """\
node.add_on_set_parameters_callback(
    lambda _: __import__("rcl_interfaces.msg").msg.SetParametersResult(successful=False)
)
"""


@pytest.fixture(scope="module")
def observer() -> Iterator[Observer]:
    with Observer() as observer:
        yield observer


Watched = Callable[..., Recording]


@pytest.fixture
def watched(observer: Observer, tmp_path: Path) -> Watched:
    def watch_it(text: str, clock: str = "simulated", plan: Plan = PLAN) -> Recording:
        with Watch(observer, ProgramSpec(write(tmp_path, text)), plan, clock) as watch:  # type: ignore[arg-type]
            return watch.finish(watch.observe())

    return watch_it


def all_about(intervals: list[float], period: float) -> bool:
    """Return whether each interval equals the period (s) to within a step of simulated time."""
    return all(abs(one - period) <= 0.051 for one in intervals)


def has_two_paces(recording: Recording) -> bool:
    """Return whether simulated time ran at two speeds, one at least twice the other."""
    speeds = [stretch.speed for stretch in recording.stretches]
    return 2 * min(speeds) <= max(speeds)


def real_speed(recording: Recording, stretch: Stretch) -> float:
    """Return the simulated seconds per real second between a stretch's first and last message; 0 if unknown."""
    heard = [one for one in recording.topic("/battery").arrivals if stretch.start < one.t <= stretch.end]
    if len(heard) < 2:
        return 0.0
    return (heard[-1].t - heard[0].t) / (heard[-1].wall - heard[0].wall)


def test_two_timers_on_simulated_time_are_recorded_exactly(watched: Watched) -> None:
    recording = watched(TWO_TIMERS)
    assert recording.follows_clock
    assert recording.watched_s == 9.0
    assert recording.step_s == 0.05
    assert has_two_paces(recording)
    battery, status = recording.topic("/battery"), recording.topic("/status")
    assert len(battery.arrivals) == 9
    assert len(status.arrivals) == 18
    for topic, period in ((battery, 1.0), (status, 0.5)):
        assert all_about(intervals_of(recording, topic.name), period), topic.arrivals
    assert [arrival.value["data"] for arrival in battery.arrivals] == [
        battery.arrivals[0].value["data"] - 0.5 * n for n in range(9)
    ]
    assert recording.following == {"/battery": True, "/status": True}


def test_a_recording_tells_nodes_types_and_qos(watched: Watched) -> None:
    recording = watched(TWO_TIMERS)
    assert [node.name for node in recording.nodes] == ["/robot/humanoid"]
    assert [topic.name for topic in recording.with_publishers()] == ["/battery", "/status"]
    [publisher] = recording.topic("/battery").publishers
    assert (publisher.node, publisher.type) == ("/robot/humanoid", "std_msgs/msg/Float32")
    assert (publisher.reliability, publisher.durability) == ("reliable", "volatile")
    assert publisher.last_seen is None
    process = recording.process
    assert process.ended_by == "judge"
    assert process.program == "answer.py"
    assert process.log == ""


def test_an_arrival_tells_when_it_was_published(watched: Watched) -> None:
    recording = watched(TWO_TIMERS)
    arrivals = recording.topic("/battery").arrivals
    assert all(one.sent is not None and one.published < one.wall for one in arrivals)
    assert [one.published for one in arrivals] == sorted(one.published for one in arrivals)


def test_setting_the_clock_of_the_machine_moves_no_message(
    watched: Watched, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Message times come from the system clock. If it is set by an hour, the recorder's offset is wrong by an hour."""
    start_windows = Recorder.start_windows

    def set_clock(self: Recorder, t: float) -> None:
        start_windows(self, t)
        self._epoch_offset -= 3600.0

    monkeypatch.setattr(Recorder, "start_windows", set_clock)
    recording = watched(TWO_TIMERS)
    battery = recording.topic("/battery").arrivals
    assert len(battery) == 9
    assert 0.0 <= battery[0].t <= 1.0
    assert all_about(intervals_of(recording, "/battery"), 1.0)


def test_the_wall_clock_gives_real_seconds(watched: Watched) -> None:
    recording = watched(OWN_CLOCK.format(options=""), "wall")
    assert (recording.clock, recording.step_s, recording.follows_clock) == ("wall", None, None)
    assert not recording.stretches
    window = recording.topic("/battery").window
    assert window is not None
    assert window[0] == 0.0
    assert window[1] >= PLAN.wall_s
    assert recording.topic("/battery").publishers[0].first_seen == 0.0
    assert len(recording.topic("/battery").arrivals) >= 3
    times = [arrival.t for arrival in recording.topic("/battery").arrivals]
    assert times == sorted(times)
    assert all(0.0 <= t <= recording.watched_s for t in times)


def test_a_program_on_its_own_clock_is_never_taken_for_one_that_follows(watched: Watched) -> None:
    recording = watched(OWN_CLOCK.format(options=""))
    assert recording.follows_clock
    assert True not in recording.following.values()


def test_what_runs_beside_a_sleeping_thread_is_told_from_it(watched: Watched) -> None:
    """One topic is published by a timer, one by a sleeping thread. Only the first one follows the clock."""
    recording = watched(TIMER_AND_SLEEP)
    assert recording.follows_clock
    assert recording.following.get("/battery") is True
    assert recording.following.get("/status") is not True


def test_a_slow_pace_is_slow_beside_what_the_machine_could_do(
    watched: Watched, monkeypatch: pytest.MonkeyPatch
) -> None:
    """On a busy machine, a program that never rests slows the fast pace down, here as far as the slow one."""
    monkeypatch.setattr("workbook.watching.simulated_time.SPEEDS", (SPEEDS[0], SPEEDS[0]))
    recording = watched(TIMER_AND_SLEEP)
    assert not recording.in_lockstep
    assert has_two_paces(recording)
    assert recording.following.get("/battery") is True


ONE_PAIR = replace(PLAN, simulated_seconds=17.0)
"""A fast block of 8.5 s, and a slow one. Three intervals of each topic take 3 s."""


def ends_of_the_second_half(recording: Recording) -> list[float]:
    """Return the ends (s, simulated) of the stretches that begin in the second half of the watch."""
    return [round(stretch.end, 3) for stretch in recording.stretches if stretch.start > 8.4]


def test_the_slow_pace_lasts_only_until_all_topics_are_proved_to_follow(watched: Watched) -> None:
    recording = watched(TWO_TIMERS, plan=ONE_PAIR)
    assert recording.following == {"/battery": True, "/status": True}
    assert recording.watched_s == 17.0
    slow, *_, last = ends_of_the_second_half(recording)
    assert 11.5 <= slow <= 13.5
    assert last == 17.0
    assert len(recording.topic("/battery").arrivals) == 17


def test_the_slow_pace_lasts_as_long_as_a_topic_has_proved_nothing(watched: Watched) -> None:
    recording = watched(TIMER_AND_SLEEP, plan=ONE_PAIR)
    assert recording.following.get("/status") is not True
    assert ends_of_the_second_half(recording) == [17.0]


def test_a_slow_topic_gets_more_simulated_time_which_is_not_judged(watched: Watched) -> None:
    """In the 9 judged seconds, two messages with a period of 4 s prove nothing, so the clock runs on until they do."""
    recording = watched(TWO_TIMERS.replace("create_timer(1.0,", "create_timer(4.0,"))
    assert recording.watched_s == 9.0
    assert len(recording.topic("/battery").arrivals) == 2
    assert all_about(intervals_of(recording, "/battery"), 4.0)
    assert recording.following == {"/battery": True, "/status": True}


def test_simulated_time_waits_for_a_program_that_is_slow_to_set_up(watched: Watched) -> None:
    slow = "        time.sleep(2.0)\n        self.battery_pub"
    recording = watched("import time\n" + TWO_TIMERS.replace("        self.battery_pub", slow, 1))
    assert recording.follows_clock
    assert len(recording.topic("/battery").arrivals) == 9
    assert recording.following == {"/battery": True, "/status": True}


@pytest.mark.parametrize("options", [", start_parameter_services=False", ", enable_rosout=False"])
def test_a_program_that_cannot_be_switched_is_watched_on_the_wall_clock(
    watched: Watched, options: str
) -> None:
    """The second program offers the services but refuses the call."""
    text = OWN_CLOCK.format(options=options)
    if "enable_rosout" in options:
        text = text.replace("battery, status", f"{REFUSAL}battery, status", 1)
    recording = watched(text)
    assert (recording.clock, recording.follows_clock, recording.stretches) == ("wall", False, ())
    assert recording.topic("/battery").arrivals


def test_a_program_that_subscribes_to_the_clock_by_itself_is_noticed(watched: Watched) -> None:
    own = ', parameter_overrides=[rclpy.parameter.Parameter("use_sim_time", value=True)]'
    recording = watched(TWO_TIMERS.replace('"humanoid"', f'"humanoid"{own}'))
    assert recording.own_clock == ("/robot/humanoid",)
    assert recording.clock == "wall"
    assert not recording.topic("/battery").arrivals


def test_a_callback_that_sleeps_longer_than_simulated_time_gives_it_proves_nothing(watched: Watched) -> None:
    """In lockstep, the clock would wait for the callback, and every message would seem to be on time."""
    timer = "        self.create_timer(0.5, self.tell_status)\n"
    busy = f"{timer}        self.create_timer(0.1, lambda: __import__('time').sleep(0.07))\n"
    recording = watched(TWO_TIMERS.replace(timer, busy))
    assert recording.follows_clock is False
    assert not recording.following


def test_in_real_time_rates_are_compared_within_a_factor(watched: Watched) -> None:
    real = watched(TWO_TIMERS, "wall")
    assert (real.clock, real.step_s) == ("wall", None)
    assert len(intervals_of(real, "/status")) >= 3
    for topic, period in (("/battery", 1.0), ("/status", 0.5)):
        assert not rates_differ(period, real, topic)
        assert rates_differ(period / 2, real, topic)


def test_a_watch_on_the_wall_clock_ends_early_when_it_is_enough(observer: Observer, tmp_path: Path) -> None:
    plan = replace(PLAN, wall_seconds=3600.0)
    with Watch(observer, ProgramSpec(write(tmp_path, TWO_TIMERS)), plan, "wall") as watch:
        assert watch.observe(lambda: True).watched_s < 60.0


def test_a_program_that_ends_early(watched: Watched) -> None:
    recording = watched("print('nothing to do')\n")
    assert (recording.process.ended_by, recording.process.exit) == ("itself", 0)
    assert recording.process.log == "nothing to do\n"
    assert recording.follows_clock is None
    assert recording.watched_s == 0.0
    assert not recording.topics


def test_a_program_that_ends_in_the_middle(watched: Watched) -> None:
    text = TWO_TIMERS.replace(
        "self.level -= 0.5", "self.level -= 0.5\n        if self.level < 99.0: raise SystemExit(3)"
    )
    recording = watched(text, plan=replace(PLAN, simulated_seconds=300.0))
    assert (recording.process.ended_by, recording.process.exit) == ("itself", 3)
    assert [arrival.value["data"] for arrival in recording.topic("/battery").arrivals] == [99.5, 99.0]
    assert recording.watched_s < 150.0, "the rest of the plan was left out"


def test_a_program_that_cannot_be_read_is_over_at_once(watched: Watched) -> None:
    recording = watched("speed = = 3\n")
    assert recording.process.ended_by == "itself"
    assert "SyntaxError" in recording.process.log


def test_a_best_effort_and_a_latched_publisher_are_heard(watched: Watched) -> None:
    text = TWO_TIMERS.replace('"/battery", 10', '"/battery", rclpy.qos.qos_profile_sensor_data').replace(
        '"/status", 10',
        '"/status", rclpy.qos.QoSProfile(depth=1, durability=rclpy.qos.DurabilityPolicy.TRANSIENT_LOCAL)',
    )
    recording = watched(text)
    assert recording.topic("/battery").publishers[0].reliability == "best_effort"
    assert recording.topic("/status").publishers[0].durability == "transient_local"
    assert len(recording.topic("/battery").arrivals) == 9
    assert len(recording.topic("/status").arrivals) == 18


HANDED_OVER = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String

rclpy.init()
first, second = Node("first"), Node("second")
battery = second.create_publisher(Float32, "/battery", 10)
status = first.create_publisher(String, "/status", 10)


def hand_over():
    hand_over_once.cancel()
    second.create_publisher(String, "/status", 10)
    first.destroy_publisher(status)


hand_over_once = second.create_timer(1.0, hand_over)
rclpy.spin(second)
"""


def test_a_publisher_that_takes_the_place_of_another_is_noticed(watched: Watched) -> None:
    recording = watched(HANDED_OVER, "wall")
    gone, there = sorted(recording.topic("/status").publishers, key=lambda publisher: publisher.node)
    assert (gone.node, there.node) == ("/first", "/second")
    assert gone.last_seen is not None
    assert there.last_seen is None


def test_a_node_on_another_domain_is_told(watched: Watched, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("workbook.watching.waiting.FIRST_SIGN_S", 6.0)
    with lease_domain() as other:
        recording = watched(TWO_TIMERS.replace("rclpy.init()", f"rclpy.init(domain_id={other.domain_id})"))
        assert recording.process.domains_used == (other.domain_id,)
        assert not recording.topics


IMPORTS_FOR_LONG = """
import time
while time.process_time() < @@BUSY@@:
    pass
"""


def test_a_program_that_imports_large_libraries_is_waited_for(
    watched: Watched, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("workbook.watching.waiting.FIRST_SIGN_S", 0.3)
    recording = watched(IMPORTS_FOR_LONG.replace("@@BUSY@@", "1.2") + TWO_TIMERS, "wall")
    assert recording.topic("/status").arrivals


def test_a_loop_without_end_is_not(watched: Watched, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("workbook.watching.waiting.FIRST_SIGN_S", 0.3)
    monkeypatch.setattr("workbook.watching.waiting.STARTS_PROCESSOR_S", 0.5)
    recording = watched(IMPORTS_FOR_LONG.replace("@@BUSY@@", "60") + TWO_TIMERS, "wall")
    assert not recording.topics
    assert recording.wall_s < 20.0


def test_keep_watching_ends_early_when_it_is_enough(observer: Observer, tmp_path: Path) -> None:
    with Watch(observer, ProgramSpec(write(tmp_path, TWO_TIMERS)), PLAN, "wall") as watch:
        recording = watch.observe()
        asked: list[bool] = []

        def cancel_soak() -> bool:
            asked.append(True)
            return len(asked) == 3

        assert watch.keep_watching(3600.0, cancel_soak) is False
        assert len(asked) == 3
        ended = watch.finish(recording)
    assert ended.process.ended_by == "judge"
    assert ended.topics == recording.topics


@pytest.mark.whole
def test_keep_watching_ends_with_the_program(observer: Observer, tmp_path: Path) -> None:
    text = TWO_TIMERS.replace(
        "self.level -= 0.5", "self.level -= 0.5\n        if self.level < 95.0: raise SystemExit(0)"
    )
    with Watch(observer, ProgramSpec(write(tmp_path, text)), PLAN, "wall") as watch:
        recording = watch.observe()
        assert recording.process.ended_by is None
        watch.keep_watching(3600.0)
        assert watch.finish(recording).process.ended_by == "itself"


def test_a_killed_program_sends_the_observer_to_another_domain(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    stubborn = "import signal\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\n" + TWO_TIMERS.replace(
        "rclpy.init()", "rclpy.init(signal_handler_options=rclpy.signals.SignalHandlerOptions.NO)"
    )
    with Observer() as observer:
        before = observer.domain_id
        with Watch(observer, ProgramSpec(write(tmp_path, stubborn)), PLAN, "simulated") as watch:
            recording = watch.finish(watch.observe())
        assert recording.process.signal == "SIGKILL"
        assert observer.domain_id != before
        assert recording.domain_id == before
        with lease_domain(preferred=before) as lease:
            assert lease.domain_id != before, "the domain of a killed program rests"


def test_two_observers_at_once_do_not_hear_each_other(tmp_path: Path) -> None:
    found: dict[str, Recording] = {}

    def watch_alone(name: str) -> None:
        program = write(tmp_path, TWO_TIMERS.replace("humanoid", name), f"{name}.py")
        with Observer() as observer, Watch(observer, ProgramSpec(program), PLAN, "simulated") as watch:
            meeting.wait(60.0)
            found[name] = watch.finish(watch.observe())

    meeting = threading.Barrier(2)
    threads = [threading.Thread(target=watch_alone, args=(name,)) for name in ("left", "right")]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found["left"].domain_id != found["right"].domain_id
    for name, recording in found.items():
        assert [node.name for node in recording.nodes] == [f"/robot/{name}"]
        assert len(recording.topic("/battery").publishers) == 1


def test_a_closed_observer_is_closed() -> None:
    observer = Observer()
    domain_id = observer.domain_id
    observer.close()
    with lease_domain(preferred=domain_id) as lease:
        assert lease.domain_id == domain_id
    observer.close()
