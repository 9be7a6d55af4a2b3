"""What messages do to the robot of the panel."""

import math
from typing import Any

import pytest
from geometry_msgs.msg import Twist, Vector3Stamped
from sensor_msgs.msg import JointState
from std_msgs.msg import Bool, Empty, Float32, Float32MultiArray, Int32, String

from workbook.lab.panel.reactions import REACTIONS
from workbook.lab.panel.robot import GRACE_S, WORDS_EVERY_S, PanelRobot
from workbook.pictures.joints import NEUTRAL


def walks() -> Twist:
    message = Twist()
    message.linear.x, message.angular.z = 0.5, -0.25
    return message


def to_the_left() -> Vector3Stamped:
    message = Vector3Stamped()
    message.vector.x, message.vector.z = -1.0, 1.0
    return message


REACTS = [
    ("/robot/joint_positions", Float32MultiArray(data=[0.5] * 12), {"pose": [0.5] * 12}),
    (
        "/robot/joint_states",
        JointState(name=["waist", "tail"], position=[0.25, 9.0]),
        {"pose": [0.0, 0.25, *NEUTRAL[2:]]},
    ),
    ("/robot/heartbeat", String(data="beat 1"), {"beat": 1}),
    ("/robot/heartbeat", Empty(), {"beat": 1}),
    ("/robot/battery", Float32(data=41.5), {"battery": 41.5, "words": "battery: 42 %"}),
    ("/monitor/battery", Float32(data=150.0), {"battery": 150.0, "words": "battery: 150 %"}),
    (
        "/robot/status",
        String(data="operational"),
        {"face": "operational", "words": "status: operational"},
    ),
    ("/robot/status", String(data="error"), {"face": "error", "words": "status: error"}),
    ("/robot/status", String(data="bored"), {"face": "awake", "words": "status: bored"}),
    ("/robot/health", String(data="no answer"), {"face": "error", "words": "health: no answer"}),
    ("/robot/tilt", Float32(data=0.125), {"tilt": 0.125}),
    ("/robot/cmd_vel", walks(), {"walk": [0.5, -0.25]}),
    ("/robot/touch", Int32(data=3), {"touch": 1}),
    ("/monitor/seen", Int32(data=3), {"touch": 1}),
    ("/robot/head_angle", Float32(data=0.5), {"look": 0.5}),
    ("/robot/ball_direction", to_the_left(), {"look": math.pi / 4}),
    ("/robot/ball_direction", Vector3Stamped(), {"look": 0.0}),
    ("/dashboard/alarm", Bool(data=True), {"alarm": True, "words": "alarm: True"}),
    ("/monitor/alarm", String(data="bad reading: 300"), {"alert": 1, "words": "alarm: bad reading: 300"}),
    ("/camera/frame", String(data="picture 1"), {"words": "frame: picture 1"}),
    ("/robot/battery", String(data="full"), {"words": "battery: full"}),
    ("/robot/battery", Float32(data=math.nan), {"words": "battery: the battery is nan, which isn't a number to show"}),
    ("/robot/tilt", Float32(data=math.inf), {"words": "tilt: the angle is inf, which isn't a number to show"}),
    (
        "/robot/joint_positions",
        Float32MultiArray(data=[0.5]),
        {"words": "joint_positions: the humanoid has 12 joints, so it needs 12 angles, not 1"},
    ),
]  # fmt: skip


def take(robot: PanelRobot, topic: str, message: Any, now: float) -> None:
    kind = type(message)
    line = str(getattr(message, "data", "")) if isinstance(message, (String, Bool)) else "a message"
    robot.take(topic, f"{kind.__module__.split('.')[0]}/msg/{kind.__name__}", message, line, now)


@pytest.mark.parametrize(("topic", "message", "does"), REACTS)
def test_a_message_does_what_the_table_says(topic: str, message: Any, does: dict[str, Any]) -> None:
    robot = PanelRobot()
    assert robot.news(0.0)["awake"] is False
    take(robot, topic, message, 1.0)
    news = robot.news(1.0)
    assert news.pop("awake") is True
    text = news.pop("text")
    assert text.endswith(f"posed by the last message on {topic}" if "pose" in does else "awake")
    assert news.pop("words") == does.pop("words", "")
    assert news == {effect: pytest.approx(value) for effect, value in does.items()}
    assert robot.news(2.0) == {}, "told once"


def test_each_row_of_the_table_is_tried() -> None:
    tried = {(topic.rpartition("/")[2], type(message).__name__) for topic, message, _ in REACTS}
    for row in REACTIONS:
        kinds = [kind for name, kind in tried if name == row.name or row.name == "beat"]
        assert (row.type_name is None and kinds) or str(row.type_name).rpartition("/")[2] in kinds, row


def test_moments_are_counted_and_lasting_effects_are_told_once() -> None:
    robot = PanelRobot()
    for beat in range(3):
        take(robot, "/robot/heartbeat", String(data="beat"), 0.01 * beat)
        take(robot, "/robot/battery", Float32(data=50.0), 0.01 * beat)
    news = robot.news(0.1)
    assert (news["beat"], news["battery"]) == (3, 50.0)
    take(robot, "/robot/battery", Float32(data=50.0), 0.2)
    assert robot.news(0.2) == {}


def test_words_come_at_a_rate_that_can_be_read() -> None:
    robot = PanelRobot()
    told = []
    for step in range(100):
        take(robot, "/robot/mood", String(data=str(step)), step / 100)
        told += [news["words"] for news in (robot.news(step / 100),) if "words" in news]
    assert len(told) == 1 / WORDS_EVERY_S
    assert robot.news(2.0)["words"] == "mood: 99"


def test_it_falls_asleep_when_all_nodes_are_gone() -> None:
    robot = PanelRobot()
    take(robot, "/robot/tilt", Float32(data=0.5), 0.0)
    robot.look(False, set(), GRACE_S / 2)
    assert robot.news(GRACE_S / 2)["awake"], "its publisher may not be on the graph yet"
    robot.look(True, {"/robot/tilt"}, 5.0)
    assert robot.news(5.0) == {}
    robot.look(True, set(), 6.0)
    assert robot.news(6.0) == {"tilt": None}
    robot.look(False, set(), 7.0)
    news = robot.news(7.0)
    assert news["awake"] is False and news["text"].endswith("asleep") and news["words"].startswith("Asleep")


def test_a_node_that_says_nothing_wakes_it() -> None:
    robot = PanelRobot()
    robot.look(True, set(), 0.0)
    assert robot.news(0.0)["text"].endswith("awake")
