"""Which spins of a program may explain its silence, and what the feedback says about them."""

from dataclasses import replace

import pytest
from std_msgs.msg import Float32

import workbook.criteria as see
from tests.criteria.by_hand import every, on_topic, publisher, recorded
from workbook.criteria import topic
from workbook.exercise.spins import repeated_init, spins_in, spins_in_a_callback

BATTERY = topic("/robot/battery", Float32, hz=0.5)
NODE = """
class Robot(Node):
    def __init__(self):
        super().__init__("robot")
        {made}

    def beat(self):
        {beat}

    def wait(self):
        {wait}

def main():
    {main}
"""


def program(
    made: str = "self.create_timer(1.0, self.beat)",
    beat: str = "pass",
    wait: str = "pass",
    main: str = "pass",
) -> str:
    return NODE.format(made=made, beat=beat, wait=wait, main=main)


@pytest.mark.parametrize(
    "text",
    [
        program(beat="rclpy.spin_once(self, timeout_sec=0.01)"),
        program(beat="self.executor.spin_once(0.01)"),
        program(beat="self.wait()", wait="rclpy.spin_until_future_complete(self, self.future)"),
        program(beat="while not done:\n            rclpy.spin_once(self)"),
        program(made="self.create_subscription(String, 'a', self.beat, 10)", beat="rclpy.spin_once(self)"),
        program(made="self.create_timer(1.0, callback=self.beat)", beat="rclpy.spin_once(self)"),
        program(made="self.create_timer(1.0, lambda: rclpy.spin_once(self))"),
        program(made="self.create_timer(1.0, partial(self.beat, 1))", beat="rclpy.spin_once(self)"),
    ],
)
def test_spins_in_callbacks_are_found(text: str) -> None:
    assert spins_in_a_callback(text)


@pytest.mark.parametrize(
    "text",
    [
        program(main="rclpy.spin(Robot())"),
        program(wait="rclpy.spin_once(self)", main="Robot().wait()"),
        program(beat="Thread(target=self.wait).start()", wait="rclpy.spin(self)"),
        program(main="executor.spin()\n    node.destroy_node()"),
        program(main="try:\n        rclpy.spin(node)\n    finally:\n        rclpy.try_shutdown()"),
        program(main="while rclpy.ok():\n        rclpy.spin_once(node)\n        publisher.publish(message)"),
        "this is no Python",
    ],
)
def test_other_spins_are_not(text: str) -> None:
    assert not spins_in(text)


@pytest.mark.parametrize(
    ("text", "kept"),
    [
        (program(main="rclpy.spin(heart)\n    rclpy.spin(battery)"), "spin"),
        (program(main="run(heart)\n    run(battery)") + "\ndef run(node):\n    rclpy.spin(node)\n", "spin"),
        (program(main="for node in nodes:\n        rclpy.spin(node)"), "round"),
        (program(made="rclpy.spin(self)\n        self.create_timer(1.0, self.beat)"), "create"),
        (program(made="rclpy.spin(self)", main="node = Robot()\n    rclpy.spin(node)"), "spin"),
        (program(main="executor.spin()\n    node.create_timer(1.0, node.beat)"), "create"),
    ],
)
def test_what_a_spin_keeps_from_running_is_found(text: str, kept: str) -> None:
    assert kept in {one.kept for one in spins_in(text)}


RATE = "self.rate = self.create_rate(2)\n        self.create_timer(1.0, self.beat)"
LOOP = "rate = node.create_rate(2)\n    while rclpy.ok():\n        rate.sleep()"


@pytest.mark.parametrize(
    ("text", "callback"),
    [
        (program(made=RATE, beat="self.rate.sleep()"), "beat"),
        (program(made=RATE, beat="self.wait()", wait="self.rate.sleep()"), "beat"),
        (program(beat="self.create_rate(2).sleep()"), "beat"),
        (
            program(made="self.create_subscription(String, 'a', self.beat, 10)", beat="rate.sleep()")
            + "    rate = node.create_rate(2)\n    Thread(target=executor.spin).start()\n",
            "beat",
        ),
        (program(made="rate = self.create_rate(2)\n        rate.sleep()"), ""),
        (program(main=LOOP), ""),
        (program(main=f"{LOOP}\n        rclpy.spin_once(node)"), ""),
    ],
)
def test_waits_for_a_rate_that_nothing_serves_are_found(text: str, callback: str) -> None:
    found = spins_in(text)
    assert [(one.callback, one.waits) for one in found] == [(callback, "rate")]
    assert not spins_in_a_callback(text)


@pytest.mark.parametrize(
    "text",
    [
        program(main=f"Thread(target=rclpy.spin, args=(node,)).start()\n    {LOOP}"),
        program(made=RATE, beat="self.rate.sleep()") + "    MultiThreadedExecutor()\n",
        program(made=RATE, beat="time.sleep(0.1)"),
        program(main="rate = node.create_rate(2)\n    while rclpy.ok():\n        rclpy.spin_once(node)"),
    ],
)
def test_other_rates_are_not(text: str) -> None:
    assert not spins_in(text)


ASYNC = program(beat="await self.future").replace("def beat", "async def beat")


def test_what_an_async_callback_awaits_is_found() -> None:
    assert [(one.callback, one.code, one.waits) for one in spins_in(ASYNC)] == [
        ("beat", "await self.future", "future")
    ]
    assert not spins_in(ASYNC + "    ReentrantCallbackGroup()\n")
    assert not spins_in(ASYNC.replace("self.create_timer(1.0, self.beat)", "pass"))


def test_a_silent_topic_is_explained_by_the_spin() -> None:
    silent = recorded(on_topic(BATTERY.name))
    for text, cause in (
        (program(made=RATE, beat="self.rate.sleep()"), "spin.rate-in-a-callback"),
        (program(main=LOOP), "spin.rate-without-a-spin"),
        (ASYNC, "spin.await-in-a-callback"),
        (program(beat="rclpy.spin_once(self)"), "spin.in-a-callback"),
        (program(main="rclpy.spin(heart)\n    rclpy.spin(battery)"), "spin.second-never-reached"),
        (program(main="for node in nodes:\n        rclpy.spin(node)"), "spin.first-round-only"),
        (program(made="rclpy.spin(self)\n        self.create_timer(1.0, self.beat)"), "spin.before-the-rest"),
    ):
        assert see.rate(replace(silent, spins=spins_in(text)), BATTERY).cause == cause


def test_a_topic_in_its_rhythm_is_right_whatever_the_source_says() -> None:
    right = recorded(on_topic(BATTERY.name, times=every(2.0, 7)))
    assert see.rate(replace(right, spins=spins_in(program(beat="rclpy.spin_once(self)"))), BATTERY).ok


ROUND = "    rclpy.init()\n    node = Node('robot')\n    node.destroy_node()\n    rclpy.shutdown()\n"


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (f"while True:\n{ROUND}", 2),
        (f"def say():\n{ROUND}\nfor _ in range(9):\n    say()\n", 2),
        (f"def say():\n{ROUND}\ndef main():\n    while True:\n        say()\n        time.sleep(1)\n", 2),
        (f"def main():\n{ROUND}\nmain()\n", 0),
        ("rclpy.init()\nwhile rclpy.ok():\n    rclpy.spin_once(node)\n", 0),
    ],
)
def test_a_loop_that_initializes_ros_is_found(text: str, line: int) -> None:
    assert repeated_init(text) == line


def test_a_node_that_lives_too_briefly_is_explained_by_its_loop() -> None:
    gone = replace(publisher(BATTERY.type), last_seen=1.0)
    recording = recorded(replace(on_topic(BATTERY.name), publishers=(gone,)), nodes=False)
    for seen in (recording, recorded(nodes=False)):
        assert see.program_runs(replace(seen, repeated_init=4)).cause == "spin.initialized-again"
