"""How exercise 05 is judged: a minute of robot time, and how often each topic spoke in it."""

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import Recording, Topic, Verdict, criterion, topic, watching

WATCH = watching(robot_seconds=60)

HEARTBEAT = topic("/robot/heartbeat", String, hz=1.0)
BATTERY = topic("/robot/battery", Float32, hz=0.5)
TILT = topic("/robot/tilt", Float32, hz=5.0)


def in_rhythm(recording: Recording, one: Topic) -> Verdict:
    """Evenly, as often as asked, and counted over the whole watch."""
    return see.all_of(see.rate(recording, one), see.counts(recording, one), see.keeps_period(recording, one))


@criterion(points=0, title="Your program runs and its node is on the graph")
def program_runs(recording: Recording) -> Verdict:
    return see.program_runs(recording)


@criterion(points=1, title="/robot/heartbeat carries String", needs=[program_runs])
def heartbeat_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, HEARTBEAT)


@criterion(points=2, title="The heart beats at 1 Hz: 60 times a minute", needs=[heartbeat_topic])
def heartbeat_count(recording: Recording) -> Verdict:
    return in_rhythm(recording, HEARTBEAT)


@criterion(points=1, title="/robot/battery carries Float32", needs=[program_runs])
def battery_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, BATTERY)


@criterion(points=2, title="The battery reports at 0.5 Hz: 30 times a minute", needs=[battery_topic])
def battery_count(recording: Recording) -> Verdict:
    return in_rhythm(recording, BATTERY)


@criterion(points=1, title="/robot/tilt carries Float32", needs=[program_runs])
def tilt_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, TILT)


@criterion(points=2, title="The tilt comes at 5 Hz: 300 times a minute", needs=[tilt_topic])
def tilt_count(recording: Recording) -> Verdict:
    return in_rhythm(recording, TILT)


@criterion(points=1, title="The program is still alive at the end", needs=[program_runs])
def alive_at_end(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)
