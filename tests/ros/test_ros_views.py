"""A lesson's robot is drawn when it moves, and only then."""

import pytest

LOOKS = "print([view.frame() is not None for _ in range(3)])"


@pytest.fixture
def watching(kernel):
    kernel.good(
        "from std_msgs.msg import Float32MultiArray\n"
        "from workbook.lesson.views import RobotView\n"
        "init()\n"
        "view = RobotView(ease=0.0)\n"
        "mover = fresh(Node, 'mover')\n"
        "joints = mover.create_publisher(Float32MultiArray, '/robot/joint_positions', 10)\n"
        "lamp = mover.create_publisher(String, '/robot/status', 10)\n"
        "async def move(angles):\n"
        "    before = view.robot.received\n"
        "    await run(view, until=lambda: joints.get_subscription_count() > 0)\n"
        "    joints.publish(Float32MultiArray(data=angles))\n"
        "    await run(view, until=lambda: view.robot.received > before)\n"
    )
    return kernel


def test_a_robot_that_stands_still_is_drawn_once(watching):
    assert watching.good(LOOKS).text == "[True, False, False]\n"
    for angles, drawn in (("[0.1] * 12", True), ("[0.1] * 12", False), ("[0.2] * 12", True)):
        watching.good(f"await move({angles})")
        assert watching.good(LOOKS).text == f"[{drawn}, False, False]\n"


def test_a_complaint_and_the_lamp_are_drawn_as_well(watching):
    watching.good("await move([0.1] * 12)\nview.frame()\nawait move([0.1] * 11)")
    assert watching.good("print(view.robot.complaint)\n" + LOOKS).text.endswith("[True, False, False]\n")
    watching.good("await move([0.1] * 12)\nview.frame()")
    watching.good(
        "await run(view, until=lambda: lamp.get_subscription_count() > 0)\n"
        "lamp.publish(String(data='error'))\n"
        "await run(view, until=lambda: view.robot.lamp == 'error')"
    )
    assert watching.good(LOOKS).text == "[True, False, False]\n"


def test_pictures_that_take_long_leave_most_of_the_time_to_the_nodes(kernel):
    kernel.good("init()\ntalker = fresh(Talker, 0.02)\nspent, drawn = [], []")
    kernel.good(
        "def draw():\n"
        "    began = time.monotonic()\n"
        "    time.sleep(0.1)\n"
        "    drawn.append(time.monotonic() - began)\n"
        "began = time.monotonic()\n"
        "await live(talker, each_frame=draw, seconds=3.0, fps=20)\n"
        "spent.append(time.monotonic() - began)"
    )
    outcome = kernel.good(
        "print(len(drawn) > 2, sum(drawn[1:-1]) / (spent[0] - drawn[0] - drawn[-1]) <= 0.3)"
    )
    assert outcome.text == "True True\n"
