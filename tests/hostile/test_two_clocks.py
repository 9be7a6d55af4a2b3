"""Programs that behave differently on simulated time than when a person runs them."""

from pathlib import Path

import pytest

from workbook.exercise.answers import Answer
from workbook.exercise.definition import Exercise, load_exercise
from workbook.exercise.judgement import Judgement
from workbook.exercise.judging import Judge
from workbook.watching.observer import Observer

pytestmark = [pytest.mark.slow, pytest.mark.whole]

ROOT = Path(__file__).resolve().parents[2]
EXERCISE = load_exercise("09_joint_positions")
RIGHT = EXERCISE.source.solution_code
READY = '        self.get_logger().info("Humanoid status publisher started")\n'
PUBLISH_STATUS = "        self.status_publisher.publish(message)\n"
PUBLISH_JOINTS = "        self.joint_publisher.publish(message)\n"
REAL = 'if not self.get_parameter("use_sim_time").value'
SUPER = 'super().__init__("humanoid_status_publisher"'
ON_SET = """\
        from rcl_interfaces.msg import SetParametersResult

        self.add_on_set_parameters_callback(
            lambda parameters: SetParametersResult(successful={accepts})
        )
"""


LATCH = """\
        self.was_judged = getattr(self, "was_judged", False) or self.get_parameter("use_sim_time").value
        if not self.was_judged:
            return
"""


def right_answer(name: str) -> str:
    """Return a right answer from the proofs."""
    return (ROOT / "tests" / "right_answers" / EXERCISE.stem / f"{name}.py").read_text(encoding="utf-8")


def changed(old: str, new: str) -> str:
    """Return the reference answer with one part replaced."""
    assert old in RIGHT
    return RIGHT.replace(old, new)


def judged(text: str, exercise: Exercise = EXERCISE) -> Judgement:
    """Judge a program as in grading."""
    with Observer() as observer:
        return Judge(observer).judge(exercise, Answer(text), soak=True)


def clock_of(judgement: Judgement) -> str:
    assert judgement.recording is not None
    return judgement.recording.clock


def test_a_program_that_is_as_it_was_in_real_time_is_judged_on_simulated_time() -> None:
    judgement = judged(RIGHT)
    assert judgement.full_marks
    assert judgement.watched_real_life
    assert clock_of(judgement) == "simulated"


@pytest.mark.parametrize(
    ("old", "new", "lost"),
    [
        (
            PUBLISH_STATUS,
            f"{PUBLISH_STATUS}        for _ in range(9 {REAL} else 0):\n    {PUBLISH_STATUS}",
            {"status_kept"},
        ),
        (
            PUBLISH_JOINTS,
            f"        {REAL}:\n            message.data = message.data[:7]\n{PUBLISH_JOINTS}",
            {"twelve_values"},
        ),
        (
            PUBLISH_STATUS,
            f"        {REAL}:\n            return\n{PUBLISH_STATUS}",
            {"status_kept"},
        ),
        (PUBLISH_STATUS, LATCH + PUBLISH_STATUS, {"status_kept"}),
    ],
    ids=["ten times as fast", "seven angles", "silent", "silent until it was switched once"],
)
def test_what_a_program_does_in_real_time_counts(old: str, new: str, lost: set[str]) -> None:
    judgement = judged(changed(old, new))
    assert {one.id for one in judgement.criteria if one.status in ("failed", "partial")} == lost
    assert clock_of(judgement) == "wall"


@pytest.mark.parametrize(
    "late",
    [
        f"        if time.monotonic() - BEGAN > 5.0:\n            return\n{PUBLISH_STATUS}",
        f"{PUBLISH_STATUS}        while PAIRS and time.monotonic() - BEGAN > 5.0:\n    {PUBLISH_STATUS}"
        "            PAIRS.pop()\n",
    ],
    ids=["silent", "a burst"],
)
def test_what_a_program_does_after_some_real_seconds_counts(late: str) -> None:
    """Most of its intervals are still correct."""
    head = "import time\n\nBEGAN, PAIRS = time.monotonic(), [2] * 5\n"
    judgement = judged(head + changed(PUBLISH_STATUS, late))
    assert {one.id for one in judgement.criteria if one.status in ("failed", "partial")} == {"status_kept"}
    assert clock_of(judgement) == "wall"


@pytest.mark.parametrize(
    "publish",
    [
        f"{PUBLISH_STATUS}        for _ in range(9 {REAL} else 0):\n    {PUBLISH_STATUS}",
        LATCH + PUBLISH_STATUS,
    ],
    ids=["ten times as fast", "silent until it was switched once"],
)
def test_where_the_end_is_judged_what_a_program_does_in_real_time_counts_as_well(publish: str) -> None:
    exercise = load_exercise("08_humanoid_status_publisher")
    text = exercise.source.solution_code
    assert text.count(PUBLISH_STATUS) == 1
    judgement = judged(text.replace(PUBLISH_STATUS, publish), exercise)
    assert {one.id for one in judgement.criteria if one.status in ("failed", "partial")} == {"status_kept"}
    assert clock_of(judgement) == "wall"


@pytest.mark.parametrize("once", [False, True], ids=["on simulated time only", "only once it was switched"])
@pytest.mark.parametrize(
    ("stem", "callback", "lost"),
    [
        (
            "04_subscriptions_and_callbacks",
            "def on_battery(self, message: Float32) -> None:\n",
            {"passes_on", "alarms_come"},
        ),
        ("14_arrays_and_filters", "def on_joints(self, message: JointState) -> None:\n", {"answers_come"}),
    ],
    ids=["04", "14"],
)
def test_a_callback_that_acts_on_simulated_time_only_is_played_the_script_in_real_time(
    stem: str, callback: str, lost: set[str], once: bool
) -> None:
    exercise = load_exercise(stem)
    text = exercise.source.solution_code
    assert text.count(callback) == 1
    acts = LATCH if once else f"        {REAL}:\n            return\n"
    judgement = judged(text.replace(callback, callback + acts), exercise)
    assert {one.id for one in judgement.criteria if one.status in ("failed", "partial")} == lost
    assert clock_of(judgement) == "wall"


def test_a_topic_that_simulated_time_cannot_judge_does_not_shield_another_one() -> None:
    """A thread that waits in real time publishes the joints, so the whole program is judged on the wall clock."""
    publish = '        self.status_pub.publish(String(data="operational"))\n'
    text = right_answer("thread_with_sleep").replace("time.sleep(2.0)", "threading.Event().wait(2.0)")
    assert text.count(publish) == text.count("Event") == 1
    ten_times = f"{publish}        for _ in range(9 {REAL} else 0):\n    {publish}"
    judgement = judged(text.replace(publish, ten_times))
    assert {one.id for one in judgement.criteria if one.status in ("failed", "partial")} == {"status_kept"}
    assert clock_of(judgement) == "wall"


def test_an_answer_that_loses_a_point_on_purpose_is_watched_in_real_time_too() -> None:
    silent = f"        {REAL}:\n            return\n{PUBLISH_STATUS}"
    text = changed(PUBLISH_STATUS, silent).replace(
        PUBLISH_JOINTS, f"        message.data.pop()\n{PUBLISH_JOINTS}"
    )
    judgement = judged(text)
    lost = {one.id for one in judgement.criteria if one.status in ("failed", "partial")}
    assert lost == {"status_kept", "twelve_values"}


def test_a_program_that_sets_use_sim_time_itself_is_silent_for_a_person_too() -> None:
    own = 'parameter_overrides=[rclpy.parameter.Parameter("use_sim_time", value=True)]'
    judgement = judged(changed(SUPER, f"{SUPER}, {own}"))
    assert "no-message.own-clock" in {one.cause for one in judgement.criteria}
    assert judgement.score == 3.0
    assert clock_of(judgement) == "wall"


NOW_LOOP = """
    node = HumanoidStatusPublisher()
    due = [node.get_clock().now()] * 2
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0.02)
        for number, period in enumerate((STATUS_PERIOD_S, BATTERY_PERIOD_S)):
            if node.get_clock().now() - due[number] >= rclpy.duration.Duration(seconds=period):
                due[number] += rclpy.duration.Duration(seconds=period)
                (node.publish_status if number == 0 else node.publish_battery)()
                if number == 1:
                    node.publish_joint_positions()
"""
COMPARES_TIMES = RIGHT.replace(
    "        self.status_timer = ", "        return\n        self.status_timer = "
).replace(
    "        rclpy.spin(HumanoidStatusPublisher())\n", NOW_LOOP.replace("\n    ", "\n        ").lstrip("\n")
)


@pytest.mark.parametrize(
    "text",
    [COMPARES_TIMES, *map(right_answer, ("multi_threaded_executor", "spin_thread_and_rate"))],
    ids=["compares times of its clock", "MultiThreadedExecutor", "create_rate"],
)
def test_a_right_program_is_as_it_was_when_it_is_started_again(text: str) -> None:
    judgement = judged(text)
    assert judgement.full_marks
    assert judgement.watched_real_life
    assert clock_of(judgement) == "simulated"


@pytest.mark.parametrize(
    "text",
    [
        changed(READY, ON_SET.format(accepts="False")),
        changed(READY, ON_SET.format(accepts="1 / 0")),
        changed(SUPER, f"{SUPER}, start_parameter_services=False"),
        changed(READY, '        self.create_timer(0.1, lambda: __import__("time").sleep(0.07))\n'),
    ],
    ids=[
        "refuses the switch",
        "ends with an error at the switch",
        "has no parameter services",
        "sleeps most of the time",
    ],
)
def test_a_right_program_that_simulated_time_cannot_judge_is_judged_on_the_wall_clock(text: str) -> None:
    judgement = judged(text)
    assert judgement.full_marks
    assert clock_of(judgement) == "wall"
