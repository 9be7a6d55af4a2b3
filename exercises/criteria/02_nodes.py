"""How exercise 02 is judged: by the graph. Who is there, under which name, and what comes from whom."""

from std_msgs.msg import String

import workbook.criteria as see
from workbook.criteria import Recording, Topic, Verdict, criterion, topic, watching

WATCH = watching(robot_seconds=20)

FRONT, REAR = "/robot/camera", "/robot/rear_camera"
FRONT_FRAME = topic(f"{FRONT}/frame", String, hz=2.0)
REAR_FRAME = topic(f"{REAR}/frame", String, hz=2.0)
FAULTS = topic("/robot/faults", String)


def speakers(recording: Recording, one: Topic) -> list[str]:
    """Full names of the nodes that publish on a topic. Twins are named once."""
    return sorted({publisher.node for publisher in recording.topic(one.name).publishers})


def words(names: list[str]) -> str:
    return " and ".join(names) if names else "nobody"


def pictures_of(recording: Recording, one: Topic, node: str) -> Verdict:
    """The pictures come at their rate, and from this node."""
    there = see.publishes(recording, one)
    if there.status != "passed":
        return there
    found = speakers(recording, one)
    if found != [node]:
        return see.failed(
            f"{words(found)} on {one.name}",
            f"{node} on {one.name}, and nobody else",
            "The name of this topic is written out or remapped, so it does not follow the name of the node.",
            "Leave the driver as it was delivered and rename the node with __node:=; its private topics follow.",
        )
    if not see.values(recording, one):
        return see.failed(
            f"{node} is there, but it takes no pictures",
            f"pictures on {one.name}, two a second",
            "Nobody lets this node work. An executor serves the nodes that were added to it, and rclpy.spin(node) "
            "that one node and no other.",
            "Add both nodes to one executor: return both from make_cameras and leave main as it was.",
        )
    return see.rate(recording, one)


def both_report(recording: Recording) -> Verdict:
    """Both cameras publish on the topic that they share."""
    found = speakers(recording, FAULTS)
    expected = f"{FRONT} and {REAR} on {FAULTS.name}"
    if set(found) >= {FRONT, REAR}:
        return see.passed("both cameras report their faults")
    outside = sorted(
        name
        for name, seen in recording.topics.items()
        if name.endswith("/faults") and name != FAULTS.name and seen.publishers
    )
    if outside:
        return see.failed(
            f"{words(found)} on {FAULTS.name}; somebody reports on {' and '.join(outside)}",
            expected,
            "The name of this topic was edited or remapped. As delivered, it follows the namespace of each camera.",
            "Leave the driver as it was delivered, and remap __node only.",
        )
    return see.failed(
        f"{words(found)} on {FAULTS.name}",
        expected,
        "The name of this topic was edited or remapped, or one camera reports no faults any more.",
        "Leave the driver as it was delivered, and remap __node only.",
    )


def nobody_else_is_there(recording: Recording) -> Verdict:
    """The two cameras, each once, and no other node."""
    expected = f"{FRONT} and {REAR}, each once, and no other node"
    twins = sorted(node.name for node in recording.nodes if node.most > 1)
    if twins:
        return see.failed(
            f"twins: {words(twins)} is there more than once",
            expected,
            "Two nodes were made with one name. ROS allows it, and then nobody can tell them apart.",
            "Remap one of them: cli_args=['--ros-args', '-r', '__node:=rear_camera'].",
        )
    others = sorted({node.name for node in recording.nodes} - {FRONT, REAR})
    outside = [name for name in others if not name.startswith("/robot/")]
    if outside:
        return see.failed(
            f"{words(outside)}, outside of the namespace /robot",
            expected,
            "A node without a namespace belongs to the whole building; a second robot would have it, too.",
            "Give every node that you make namespace='/robot', and make only the two cameras.",
        )
    if others:
        return see.failed(
            f"{words(others)} as well",
            expected,
            "One more node was made than the robot has cameras, or one has another name than asked.",
            "Make the two cameras and no other node.",
        )
    return see.passed("nobody else is there")


@criterion(points=0, title="Your program runs and its node is on the graph")
def program_runs(recording: Recording) -> Verdict:
    return see.program_runs(recording)


@criterion(points=1, title="/robot/camera is on the graph, once", needs=[program_runs])
def front_node(recording: Recording) -> Verdict:
    how = "Make it so: CameraDriver(namespace='/robot'). Rename the other camera alone, by its cli_args."
    return see.on_the_graph(recording, FRONT, beside=[REAR], how=how)


@criterion(points=2, title="/robot/rear_camera is on the graph, once", needs=[program_runs])
def rear_node(recording: Recording) -> Verdict:
    how = (
        "Make it so: CameraDriver(namespace='/robot', cli_args=['--ros-args', '-r', '__node:=rear_camera'])."
    )
    return see.on_the_graph(recording, REAR, beside=[FRONT], how=f"{how} Then return both cameras.")


@criterion(points=1, title="The front camera takes pictures at 2 Hz", needs=[front_node])
def front_pictures(recording: Recording) -> Verdict:
    return pictures_of(recording, FRONT_FRAME, FRONT)


@criterion(points=2, title="The rear camera takes pictures at 2 Hz", needs=[rear_node])
def rear_pictures(recording: Recording) -> Verdict:
    return pictures_of(recording, REAR_FRAME, REAR)


@criterion(points=1, title="Both report on /robot/faults", needs=[front_node, rear_node])
def shared_faults(recording: Recording) -> Verdict:
    return both_report(recording)


@criterion(points=2, title="Nobody else is there", needs=[program_runs])
def nobody_else(recording: Recording) -> Verdict:
    return nobody_else_is_there(recording)


@criterion(points=1, title="The program is still alive at the end", needs=[program_runs])
def alive_at_end(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)
