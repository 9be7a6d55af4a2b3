"""How exercise 02 is judged: by the graph. Who is there, under which name, and what comes from whom."""

from dataclasses import replace

from std_msgs.msg import String

import workbook.criteria as see
from workbook.criteria import Recording, Topic, Verdict, criterion, program_runs, topic, watching

WATCH = watching(simulated_seconds=20, wall_seconds=6.5)

FRONT, REAR = "/robot/camera", "/robot/rear_camera"
FRONT_FRAME = topic(f"{FRONT}/frame", String, hz=2.0)
REAR_FRAME = topic(f"{REAR}/frame", String, hz=2.0)
FAULTS = topic("/robot/faults", String)  # of two nodes, so it is no topic with a pace of its own
REPORTS_HZ = 1.0  # of each camera
TWICE = 1.6  # of a rate: nearer to two times than to one
SLOW_HZ = 1.6  # 20 % below the rate of the pictures; the task names it
AS_DELIVERED = "Leave the driver as it was delivered, and remap __node only."
LONGEST_QUOTE = 60  # characters of a report that feedback quotes


@criterion(points=1, title="/robot/camera is on the graph, once", needs=[program_runs])
def front_node(recording: Recording) -> Verdict:
    how = "Write CameraDriver(namespace='/robot'). Rename only the other camera, with its cli_args."
    return see.on_the_graph(recording, FRONT, beside=[REAR], how=how)


@criterion(points=2, title="/robot/rear_camera is on the graph, once", needs=[program_runs])
def rear_node(recording: Recording) -> Verdict:
    how = "Write CameraDriver(namespace='/robot', cli_args=['--ros-args', '-r', '__node:=rear_camera'])."
    return see.on_the_graph(recording, REAR, beside=[FRONT], how=f"{how} Then return both cameras.")


@criterion(points=1, title="The front camera publishes images at 2 Hz", needs=[front_node])
def front_pictures(recording: Recording) -> Verdict:
    return pictures_of(recording, FRONT_FRAME, FRONT)


@criterion(points=2, title="The rear camera publishes images at 2 Hz", needs=[rear_node])
def rear_pictures(recording: Recording) -> Verdict:
    return pictures_of(recording, REAR_FRAME, REAR)


@criterion(points=1, title="Both report on /robot/faults, once a second", needs=[front_node, rear_node])
def shared_faults(recording: Recording) -> Verdict:
    found = publishing_nodes(recording, FAULTS)
    if not set(found) >= {FRONT, REAR}:
        return why_not_on_the_topic(recording, found)
    cameras = ((FRONT, FRONT_FRAME), (REAR, REAR_FRAME))
    for camera, frames in cameras:
        if not see.values(reports(recording, camera), FAULTS):
            return why_no_reports(recording, camera, frames)
    for camera, frames in cameras:
        verdict = reports_of(recording, camera, frames)
        if not verdict.ok:
            return verdict
    return see.passed("both cameras report their faults once a second")


@criterion(points=2, title="There is no other node", needs=[program_runs])
def nobody_else(recording: Recording) -> Verdict:
    expected = f"{FRONT} and {REAR}, each once, and no other node"
    duplicates = sorted(node.name for node in recording.nodes if node.most > 1 and node.name in (FRONT, REAR))
    if duplicates:
        return see.failed(
            "nobody-else.duplicate-name",
            f"duplicate node name: {names_or_nobody(duplicates)}, more than once",
            expected,
            "Two nodes were created with the same name. ROS allows that, but then nothing can tell them apart.",
            "Remap one of them: cli_args=['--ros-args', '-r', '__node:=rear_camera'].",
        )
    others = sorted({node.name for node in recording.nodes} - {FRONT, REAR})
    outside = [name for name in others if not name.startswith("/robot/")]
    if outside:
        return see.failed(
            "nobody-else.outside-namespace",
            f"{names_or_nobody(outside)}, outside the namespace /robot",
            expected,
            "A node outside the robot's namespace doesn't belong to one robot. A second robot would have a node "
            "with the same name.",
            "Give every node that you create namespace='/robot', and create only the two cameras.",
        )
    if others:
        return see.failed(
            "nobody-else.extra-node",
            f"also on the graph: {names_or_nobody(others)}",
            expected,
            "The program creates too many nodes, or a node has the wrong name.",
            "Create the two cameras and no other node.",
        )
    return see.passed("no other node on the graph")


@criterion(points=1, title="The program is still alive at the end", needs=[program_runs])
def alive_at_end(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)


def pictures_of(recording: Recording, frames: Topic, camera: str) -> Verdict:
    """The pictures come at their rate, and from this camera."""
    there = see.publishes(recording, frames)
    if not there.ok:
        return there if there.cause.startswith("error.") else replace(there, try_this=AS_DELIVERED)
    found = publishing_nodes(recording, frames)
    if found != [camera]:
        return see.failed(
            "pictures.other-node",
            f"{names_or_nobody(found)} on {frames.name}",
            f"{camera} on {frames.name}, and no other node",
            "This topic's name is hard-coded or remapped, so it doesn't follow the node's name.",
            "Don't change the driver, and rename the node with __node:=. Its private topics follow.",
        )
    if not see.values(recording, frames):
        return why_no_pictures(recording, frames, camera)
    verdict = see.rate(recording, frames)
    if verdict.ok:
        return verdict
    crashed = see.ended_by_error(recording, verdict.saw, verdict.expected)
    return crashed or camera_left(recording, frames, camera) or both_slow(recording, verdict) or verdict


def both_slow(recording: Recording, verdict: Verdict) -> Verdict | None:
    """A failed verdict if the pictures of both cameras come too slowly; else None. `verdict`: on one of them."""
    paces = [see.topic_pace(recording, frames).hz for frames in (FRONT_FRAME, REAR_FRAME)]
    if not all(hz is not None and hz < SLOW_HZ for hz in paces):
        return None
    return replace(
        see.failed(
            "pictures.both-slow",
            verdict.saw,
            verdict.expected,
            "The other camera is too slow, too. Something delays the executor that runs both: a callback works or "
            "sleeps, or the loop around spin_once does. Or the driver's periods were changed.",
            "Don't change the driver or main: executor.spin() runs each callback when it's due.",
            about_time=verdict.about_time,
        ),
        pace_of=verdict.pace_of,
    )


def camera_left(recording: Recording, frames: Topic, camera: str) -> Verdict | None:
    """A failed verdict if this camera left the graph while the program ran on; else None."""
    left = [publisher.last_seen for publisher in recording.topic(frames.name).publishers]
    gone = [at for at in left if at is not None]
    if recording.process.ended_by == "itself" or len(gone) < len(left):
        return None
    return see.failed(
        "pictures.camera-gone",
        f"{camera} left the graph after {max(gone):.1f} s, but the program kept running without it",
        f"{camera} on the graph for as long as the program runs",
        "Its node or its publisher was destroyed by destroy_node(), or because its context was shut down.",
        "Keep both cameras until the spin has ended.",
    )


def why_no_pictures(recording: Recording, frames: Topic, camera: str) -> Verdict:
    """Why a camera that is on the graph takes no pictures."""
    saw, expected = (
        f"{camera} is on the graph, but publishes no images",
        f"images on {frames.name}, two per second",
    )
    explained = see.ended_by_error(recording, saw, expected) or camera_left(recording, frames, camera)
    if explained is not None:
        return explained
    if see.values(reports(recording, camera), FAULTS):
        return see.failed(
            "pictures.never-taken",
            f"{camera} reports faults, but publishes no images",
            expected,
            "The node is spun, but nothing calls take_picture, or take_picture doesn't publish.",
            "Restore the driver as it was delivered.",
        )
    if not any(see.values(recording, one) for one in (FRONT_FRAME, REAR_FRAME, FAULTS)):
        return see.failed(
            "pictures.nothing-spins",
            f"{camera} is on the graph, but neither camera publishes anything",
            expected,
            "Nothing spins the nodes: there is no spin, or a line before it never returns.",
            "Restore main as it was: it adds both cameras to one executor and spins it.",
        )
    return see.failed(
        "pictures.node-not-spun",
        saw,
        expected,
        "Nothing spins this node. An executor runs only the nodes that were added to it, and rclpy.spin(node) runs "
        "only that node.",
        "Add both nodes to one executor: return both from make_cameras, and don't change main.",
    )


def reports(recording: Recording, camera: str) -> Recording:
    """The recording, of /robot/faults only what begins with the name of this camera."""
    beginning = f"{camera.rsplit('/', 1)[1]}:"
    return see.part_of(recording, FAULTS, lambda text: str(text).startswith(beginning))


def reports_of(recording: Recording, camera: str, frames: Topic) -> Verdict:
    """The fault reports of one camera come once a second. `frames`: its pictures.

    Whether its reports follow simulated time, its pictures tell: each camera may have a clock of its own.
    """
    own = reports(recording, camera)
    verdict = replace(see.rate(own, replace(FAULTS, hz=REPORTS_HZ)), pace_of=frames.name)
    if verdict.ok:
        return verdict
    saw = f"reports of {camera}: {verdict.saw}"
    if recording.process.ended_by == "itself" or not see.rate(recording, frames).ok:
        return replace(verdict, saw=saw)
    return replace(
        see.failed(
            "shared-faults.other-rate",
            saw,
            verdict.expected,
            "This camera's images arrive at the right rate, so its node works. Something else changed the reports: "
            "in the class, or after the camera was created.",
            "Restore the driver as it was delivered: it reports once per second.",
            about_time=verdict.about_time,
        ),
        pace_of=verdict.pace_of,
    )


def why_no_reports(recording: Recording, camera: str, frames: Topic) -> Verdict:
    """Why no report begins with the name of this camera, which has a publisher for them."""
    name = camera.rsplit("/", 1)[1]
    saw, expected = (
        f"no report of {camera}",
        f"one report per second on {FAULTS.name} that begins with '{name}:'",
    )
    strange = [
        text
        for text in see.values(recording, FAULTS)
        if not str(text).startswith(("camera:", "rear_camera:"))
    ]
    crashed = see.ended_by_error(recording, saw, expected)
    if crashed is not None:
        return crashed
    if strange:
        return see.failed(
            "shared-faults.nameless",
            f"{saw}; another text arrives: {str(strange[0])[:LONGEST_QUOTE]!r}",
            expected,
            "The report text was changed. It must begin with the name, so that people know which camera to repair.",
            "Restore the driver as it was delivered.",
        )
    if not see.values(recording, frames):
        return see.failed(
            "shared-faults.camera-idle",
            f"{saw}, and no image either",
            expected,
            "This node does nothing at all.",
            "First, make this node publish its images. The reports should then arrive, too.",
        )
    return why_silent(recording, camera, expected)


def why_silent(recording: Recording, camera: str, expected: str) -> Verdict:
    """Why a camera that takes pictures reports nothing under its name."""
    name, other = camera.rsplit("/", 1)[1], FRONT if camera == REAR else REAR
    hz = see.topic_pace(reports(recording, other), replace(FAULTS, hz=REPORTS_HZ)).hz
    if hz is not None and hz > TWICE * REPORTS_HZ:
        return see.failed(
            "shared-faults.name-of-the-other",
            f"no report begins with '{name}:', but {see.number(round(hz, 1))} per second begin with "
            f"'{other.rsplit('/', 1)[1]}:'",
            expected,
            "Both cameras report under the same name, or one of them reports for both.",
            "Restore the driver as it was delivered: it uses the name from get_name().",
        )
    return see.failed(
        "shared-faults.silent",
        f"no report of {camera}, although its images arrive",
        expected,
        "The node works, but nothing calls report_faults, or report_faults doesn't publish.",
        "Restore the driver as it was delivered.",
        about_time=True,
    )


def why_not_on_the_topic(recording: Recording, found: list[str]) -> Verdict:
    """Why not both cameras publish /robot/faults. `found`: the nodes that do."""
    saw = f"{names_or_nobody(found)} on {FAULTS.name}"
    expected = f"{FRONT} and {REAR} on {FAULTS.name}"
    elsewhere = other_faults_topics(recording)
    if elsewhere:
        return see.failed(
            "shared-faults.other-name",
            f"{saw}; some node reports on {' and '.join(elsewhere)}",
            expected,
            "This topic's name was edited or remapped. As delivered, it follows each camera's namespace.",
            AS_DELIVERED,
        )
    return see.failed(
        "shared-faults.missing",
        saw,
        expected,
        "This topic's name was edited or remapped, or one camera no longer has a publisher for it.",
        AS_DELIVERED,
    )


def publishing_nodes(recording: Recording, one: Topic) -> list[str]:
    """Fully qualified names of the nodes that publish on a topic, each once."""
    return sorted({publisher.node for publisher in recording.topic(one.name).publishers})


def other_faults_topics(recording: Recording) -> list[str]:
    """Topics called "faults" in another namespace, if somebody publishes there."""
    return sorted(
        name
        for name, seen in recording.topics.items()
        if name.endswith("/faults") and name != FAULTS.name and seen.publishers
    )


def names_or_nobody(names: list[str]) -> str:
    return " and ".join(names) if names else "no node"
