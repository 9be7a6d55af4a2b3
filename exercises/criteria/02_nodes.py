"""Judge exercise 02 by the graph: the nodes, their names, and the topics on which each node publishes."""

from dataclasses import dataclass, replace
from functools import cached_property

from std_msgs.msg import String

import workbook.criteria as see
from workbook.criteria import Recording, Topic, Verdict, criterion, program_runs, topic, watching

WATCH = watching(simulated_seconds=20, wall_seconds=6.5)
WORDS = see.Words(__file__)

FRONT, REAR = "/robot/camera", "/robot/rear_camera"
FRONT_FRAME = topic(f"{FRONT}/frame", String, hz=2.0)
REAR_FRAME = topic(f"{REAR}/frame", String, hz=2.0)
FAULTS = topic("/robot/faults", String)  # two nodes publish on it, so it has no rate of its own
REPORTS_HZ = 1.0  # of each camera
TWICE = 1.6  # times the required rate: nearer to twice the rate than to the rate itself
SLOW_HZ = 1.6  # 20 % below the images' rate; the task states it
AS_DELIVERED = "Restore the original driver, and remap only __node."
LONGEST_QUOTE = 60  # characters of a report that feedback quotes


@dataclass(frozen=True)
class Graph:
    """The nodes in the graph."""

    recording: Recording

    @cached_property
    def duplicates(self) -> list[str]:
        return sorted(
            node.name for node in self.recording.nodes if node.most > 1 and node.name in (FRONT, REAR)
        )

    @cached_property
    def others(self) -> list[str]:
        return sorted({node.name for node in self.recording.nodes} - {FRONT, REAR})

    @property
    def outside(self) -> list[str]:
        """The nodes outside the robot's namespace."""
        return [name for name in self.others if not name.startswith("/robot/")]


@dataclass(frozen=True)
class Camera:
    """The behavior of one of the two cameras. `frames`: the topic of its images."""

    recording: Recording
    name: str
    frames: Topic

    @property
    def publishing(self) -> list[str]:
        """The names of the nodes that publish this camera's images."""
        return publishing_nodes(self.recording, self.frames)

    @property
    def topic(self) -> str:
        return self.frames.name

    @property
    def left_at(self) -> float:
        """The time (s) at which the camera left the graph."""
        return max(one.last_seen or 0.0 for one in self.recording.topic(self.topic).publishers)

    @property
    def is_gone(self) -> bool:
        """Whether the camera left the graph while the program kept running."""
        left = [one.last_seen for one in self.recording.topic(self.topic).publishers]
        return self.recording.process.ended_by != "itself" and None not in left

    @property
    def takes_images(self) -> bool:
        return bool(see.values(self.recording, self.frames))

    @property
    def both_slow(self) -> bool:
        paces = [see.topic_pace(self.recording, one).hz for one in (FRONT_FRAME, REAR_FRAME)]
        return all(hz is not None and hz < SLOW_HZ for hz in paces)

    @cached_property
    def reports(self) -> Recording:
        """The recording, but with only those messages on /robot/faults that begin with this camera's name."""
        return see.part_of(self.recording, FAULTS, lambda text: str(text).startswith(f"{self.short_name}:"))

    @property
    def has_reported(self) -> bool:
        return bool(see.values(self.reports, FAULTS))

    @property
    def short_name(self) -> str:
        return self.name.rsplit("/", 1)[1]

    @property
    def nothing_at_all(self) -> bool:
        return not any(see.values(self.recording, one) for one in (FRONT_FRAME, REAR_FRAME, FAULTS))

    @property
    def nameless(self) -> list[str]:
        """The reports that don't begin with a camera's name, truncated."""
        texts = map(str, see.values(self.recording, FAULTS))
        return [text[:LONGEST_QUOTE] for text in texts if not text.startswith(("camera:", "rear_camera:"))]

    @property
    def other(self) -> "Camera":
        return Camera(self.recording, *((REAR, REAR_FRAME) if self.name == FRONT else (FRONT, FRONT_FRAME)))

    @property
    def reports_hz(self) -> float:
        """The rate (Hz) of the reports that begin with this camera's name."""
        return round(see.topic_pace(self.reports, replace(FAULTS, hz=REPORTS_HZ)).hz or 0.0, 1)


@dataclass(frozen=True)
class FaultsTopic:
    """The publishers of /robot/faults."""

    recording: Recording

    @property
    def publishing(self) -> list[str]:
        return publishing_nodes(self.recording, FAULTS)

    @property
    def elsewhere(self) -> list[str]:
        """The topics called "faults" in other namespaces that have a publisher."""
        return sorted(
            name
            for name, seen in self.recording.topics.items()
            if name.endswith("/faults") and name != FAULTS.name and seen.publishers
        )


def publishing_nodes(recording: Recording, one: Topic) -> list[str]:
    """Return the sorted, fully qualified names of a topic's publishing nodes, or ["no node"] if there are none."""
    return sorted({publisher.node for publisher in recording.topic(one.name).publishers}) or ["no node"]


OTHERS = WORDS.rules(
    Graph,
    "nobody-else",
    ("duplicate-name", lambda graph: graph.duplicates),
    ("outside-namespace", lambda graph: graph.outside),
    ("extra-node", lambda graph: graph.others),
)
OTHER_NODE = WORDS.cause("pictures.other-node", Camera)
GONE = WORDS.rules(Camera, "pictures", ("camera-gone", lambda camera: camera.is_gone))
BOTH_SLOW = WORDS.cause("pictures.both-slow", ("saw", "expected"))
NO_IMAGES = WORDS.rules(
    Camera,
    "pictures",
    ("none", see.otherwise, see.ended_by_error),
    ("camera-gone", lambda camera: camera.is_gone),
    ("never-taken", lambda camera: camera.has_reported),
    ("nothing-spins", lambda camera: camera.nothing_at_all),
    ("node-not-spun", see.otherwise),
)
NOT_ON_TOPIC = WORDS.rules(
    FaultsTopic, "shared-faults", ("other-name", lambda topic: topic.elsewhere), ("missing", see.otherwise)
)
NO_REPORT = WORDS.rules(
    Camera,
    "shared-faults",
    ("none", see.otherwise, see.ended_by_error),
    ("nameless", lambda camera: camera.nameless),
    ("camera-idle", lambda camera: not camera.takes_images),
    ("name-of-the-other", lambda camera: camera.other.reports_hz > TWICE * REPORTS_HZ),
    ("silent", see.otherwise),
    about_time=["silent"],
)
OTHER_RATE = WORDS.cause("shared-faults.other-rate", ("camera", "saw", "expected"))


@criterion(points=1, title="/robot/camera appears in the graph exactly once", needs=[program_runs])
def front_node(recording: Recording) -> Verdict:
    how = "Write CameraDriver(namespace='/robot'). Rename only the other camera, with its cli_args."
    return see.on_the_graph(recording, FRONT, beside=[REAR], how=how)


@criterion(points=2, title="/robot/rear_camera appears in the graph exactly once", needs=[program_runs])
def rear_node(recording: Recording) -> Verdict:
    how = "Write CameraDriver(namespace='/robot', cli_args=['--ros-args', '-r', '__node:=rear_camera'])."
    return see.on_the_graph(
        recording, REAR, beside=[FRONT], how=f"{how} Then return both cameras from make_cameras."
    )


@criterion(points=1, title="The front camera's images arrive at 2 Hz", needs=[front_node])
def front_pictures(recording: Recording) -> Verdict:
    return images_of(Camera(recording, FRONT, FRONT_FRAME))


@criterion(points=2, title="The rear camera's images arrive at 2 Hz", needs=[rear_node])
def rear_pictures(recording: Recording) -> Verdict:
    return images_of(Camera(recording, REAR, REAR_FRAME))


@criterion(
    points=1,
    title="Each camera's fault reports arrive on /robot/faults once a second",
    needs=[front_node, rear_node],
)
def shared_faults(recording: Recording) -> Verdict:
    topic = FaultsTopic(recording)
    cameras = [Camera(recording, FRONT, FRONT_FRAME), Camera(recording, REAR, REAR_FRAME)]
    if not set(topic.publishing) >= {FRONT, REAR}:
        return NOT_ON_TOPIC.verdict(topic)
    for camera in cameras:
        if not camera.has_reported:
            return NO_REPORT.verdict(camera)
    for camera in cameras:
        verdict = reports_of(camera)
        if not verdict.ok:
            return verdict
    return see.passed("each camera reports its faults once a second")


@criterion(points=2, title="There are no other nodes in the graph", needs=[program_runs])
def nobody_else(recording: Recording) -> Verdict:
    return OTHERS.first(Graph(recording)) or see.passed("no other node in the graph")


@criterion(points=1, title="The program is still running at the end", needs=[program_runs])
def alive_at_end(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)


def images_of(camera: Camera) -> Verdict:
    """Check that a camera's images come at the required rate, and from that camera's node."""
    recording, frames = camera.recording, camera.frames
    there = see.publishes(recording, frames)
    if not there.ok:
        return there if there.cause.startswith("error.") else replace(there, try_this=AS_DELIVERED)
    if camera.publishing != [camera.name]:
        return OTHER_NODE.verdict(camera)
    if not camera.takes_images:
        return NO_IMAGES.verdict(camera)
    verdict = see.rate(recording, frames)
    if verdict.ok:
        return verdict
    explained = see.ended_by_error(recording, verdict.saw, verdict.expected) or GONE.first(camera)
    return explained or (both_slow(verdict) if camera.both_slow else verdict)


def both_slow(verdict: Verdict) -> Verdict:
    """Return the verdict on one camera's rate, explained by a cause that delays both cameras."""
    told = BOTH_SLOW.verdict(saw=verdict.saw, expected=verdict.expected, about_time=verdict.about_time)
    return replace(told, pace_of=verdict.pace_of)


def reports_of(camera: Camera) -> Verdict:
    """Check that one camera's fault reports come once a second.

    The camera's images show whether its reports follow simulated time, because each camera may have its own clock.
    """
    verdict = replace(see.rate(camera.reports, replace(FAULTS, hz=REPORTS_HZ)), pace_of=camera.topic)
    if verdict.ok:
        return verdict
    told = OTHER_RATE.verdict(
        camera=camera, saw=verdict.saw, expected=verdict.expected, about_time=verdict.about_time
    )
    if camera.recording.process.ended_by == "itself" or not see.rate(camera.recording, camera.frames).ok:
        return replace(verdict, saw=told.saw)
    return replace(told, pace_of=verdict.pace_of)
