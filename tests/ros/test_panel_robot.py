"""How messages move the panel's robot."""

import base64
import io
import math
from array import array
from typing import Any

import PIL.Image
import pytest
from geometry_msgs.msg import Twist, Vector3Stamped
from sensor_msgs.msg import Image, Imu, JointState
from std_msgs.msg import Bool, Empty, Float32, Float32MultiArray, Int32, Int32MultiArray, String
from std_srvs.srv import Trigger
from visualization_msgs.msg import Marker, MarkerArray

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


def leans(x: float, y: float, z: float) -> Imu:
    message = Imu()
    up = message.linear_acceleration
    up.x, up.y, up.z = x, y, z
    return message


def detections() -> MarkerArray:
    ball = Marker(ns="ball")
    ball.pose.position.x, ball.pose.position.y = 80.0, 60.0
    ball.scale.x, ball.scale.y, ball.color.a = 12.0, 10.0, 0.5
    return MarkerArray(markers=[ball])


def image(encoding: str = "rgb8", **fields: Any) -> Image:
    return Image(
        **{"encoding": encoding, "width": 2, "height": 1, "step": 6, "data": [255, 0, 0] * 2} | fields
    )


REACTS = [
    (
        "/encoders/joint_states",
        JointState(name=["waist"], position=[0.25]),
        {"raw": [0.0, 0.25, *NEUTRAL[2:]]},
    ),
    ("/robot/imu", leans(0.1, 0.1, 9.81), {"tilt": 0.0}),
    ("/robot/imu", leans(0.0, -9.81, 0.0), {"tilt": 1.57}),
    ("/robot/imu", leans(0.0, 9.81, 9.81), {"tilt": -0.79}),
    ("/robot/imu", leans(0.0, math.nan, 0.0), {"words": "imu: the acceleration is nan, which isn't a number to show"}),
    ("/robot/plan", Float32(data=1.25), {"thought": 1, "words": "plan: a message"}),
    ("/robot/rear_camera/frame", String(data="picture 5"), {"look": 0.6}),
    ("/robot/rear_camera/frame", String(data="picture 6"), {"look": -0.6}),
    ("/robot/camera/frame", String(data=""), {"look": -0.2}),
    ("/robot/look", Int32MultiArray(data=[1, 4]), {"look": 0.2}),
    ("/robot/look", Int32MultiArray(), {"look": -0.2}),
    ("/robot/detections", detections(), {"boxes": [["ball", 80.0, 60.0, 12.0, 10.0, 0.5]]}),
    ("/camera/image", image("yuv422"), {"words": "image: the panel can't show yuv422"}),
    ("/camera/image", image(step=5), {"words": "image: 2 columns of rgb8 don't fit into rows of 5 bytes"}),
    ("/camera/image", image(height=2), {"words": "image: 2 rows need more than 6 bytes"}),
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
    assert news == {
        effect: value if effect == "boxes" else pytest.approx(value) for effect, value in does.items()
    }
    assert robot.news(2.0) == {}, "told once"


def test_each_row_of_the_table_is_tried() -> None:
    tried = {(topic, type(message).__name__) for topic, message, _ in REACTS}
    for row in REACTIONS:
        kinds = [kind for topic, kind in tried if topic.endswith(f"/{row.name}") or row.name == "beat"]
        assert (row.type_name is None and kinds) or str(row.type_name).rpartition("/")[2] in kinds, row


@pytest.mark.parametrize(("success", "effect"), [(True, "nod"), (False, "shake")])
def test_a_response_is_a_nod_or_a_shake_of_the_head(success: bool, effect: str) -> None:
    robot = PanelRobot()
    response = Trigger.Response(success=success)
    robot.take("/robot/self_test", "std_srvs/srv/Trigger", response, "all joints move", 1.0)
    news = robot.news(1.0)
    assert (news[effect], news["words"]) == (1, "self_test: all joints move")


@pytest.mark.parametrize("encoding", ["rgb8", "bgr8", "mono8"])
def test_an_image_is_compressed_now_and_then(encoding: str) -> None:
    robot = PanelRobot()
    rows = bytes([200, 10, 10] * 160 + [0] * 20) * 120 if encoding != "mono8" else bytes([200] * 500) * 120
    message = image(encoding, width=160, height=120, step=500, data=array("B", rows))
    told = []
    for step in range(10):
        take(robot, "/camera/image", message, step / 30)
        told += [news["image"] for news in (robot.news(step / 30),) if "image" in news]
    assert len({one["src"] for one in told}) == 1 and (told[0]["width"], told[0]["height"]) == (160, 120)
    with PIL.Image.open(io.BytesIO(base64.b64decode(told[0]["src"].partition(",")[2]))) as shown:
        middle = shown.convert("RGB").getpixel((80, 60))
    wanted = {"rgb8": (200, 10, 10), "bgr8": (10, 10, 200), "mono8": (200, 200, 200)}[encoding]
    assert middle == pytest.approx(wanted, abs=12)
    robot.look(True, {}, 5.0)
    assert robot.news(5.0)["image"] is None


def test_what_a_monitor_passes_on_is_more_than_what_its_sensor_says() -> None:
    robot = PanelRobot()
    take(robot, "/robot/battery", Float32(data=250.0), 0.0)
    assert robot.news(0.0)["battery"] == 250.0, "there's no monitor yet"
    both = dict.fromkeys(("/robot/battery", "/monitor/battery"), "std_msgs/msg/Float32")
    robot.look(True, both, 1.0)
    take(robot, "/monitor/battery", Float32(data=60.0), 1.1)
    take(robot, "/robot/battery", Float32(data=-3.0), 1.2)
    assert robot.news(1.3)["battery"] == 60.0
    robot.look(True, {"/robot/battery": "std_msgs/msg/Float32"}, 3.0)
    take(robot, "/robot/battery", Float32(data=-3.0), 3.1)
    assert robot.news(3.2)["battery"] == -3.0


def test_moments_are_counted_and_lasting_effects_are_told_once() -> None:
    robot = PanelRobot()
    for beat in range(3):
        take(robot, "/robot/heartbeat", String(data="beat"), 0.01 * beat)
        take(robot, "/robot/battery", Float32(data=50.0), 0.01 * beat)
    news = robot.news(0.1)
    assert (news["beat"], news["battery"]) == (3, 50.0)
    take(robot, "/robot/battery", Float32(data=50.0), 0.2)
    assert robot.news(0.2) == {}


def test_a_repeated_command_keeps_it_walking() -> None:
    robot = PanelRobot()
    told = []
    for step in range(50):
        take(robot, "/robot/cmd_vel", walks(), step / 10)
        told += [step / 10 for news in (robot.news(step / 10),) if "walk" in news]
    assert told == [0.0, 1.0, 2.0, 3.0, 4.0]
    assert [later for later in range(5, 20) if "walk" in robot.news(float(later))] == [5], (
        "the last command, once"
    )


def test_the_plumbing_of_an_exercise_says_nothing() -> None:
    robot = PanelRobot()
    take(robot, "/driver/report", String(data="done"), 0.0)
    news = robot.news(0.0)
    assert news["awake"] and news["words"] == ""


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
    robot.look(False, {}, GRACE_S / 2)
    assert robot.news(GRACE_S / 2)["awake"], "its publisher may not be in the graph yet"
    robot.look(True, {"/robot/tilt": "std_msgs/msg/Float32"}, 5.0)
    assert robot.news(5.0) == {}
    robot.look(True, {}, 6.0)
    assert robot.news(6.0) == {"tilt": None}
    robot.look(False, {}, 7.0)
    news = robot.news(7.0)
    assert news["awake"] is False and news["text"].endswith("asleep") and news["words"].startswith("Asleep")


def test_a_node_that_says_nothing_wakes_it() -> None:
    robot = PanelRobot()
    robot.look(True, {}, 0.0)
    assert robot.news(0.0)["text"].endswith("awake")
