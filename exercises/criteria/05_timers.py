"""Judge exercise 05 by a minute of simulated time: the number of messages on each topic, and their regularity."""

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import Recording, Topic, Verdict, criterion, program_runs, topic, watching

# The task says that the judge watches for a minute.
WATCH = watching(simulated_seconds=60, steps_per_period=5)

HEARTBEAT = topic("/robot/heartbeat", String, hz=1.0)
BATTERY = topic("/robot/battery", Float32, hz=0.5)
TILT = topic("/robot/tilt", Float32, hz=5.0)


@criterion(points=1, title="/robot/heartbeat carries String", needs=[program_runs])
def heartbeat_topic(recording: Recording) -> Verdict:
    published = see.publishes(recording, HEARTBEAT)
    if not published.ok or not see.values(recording, HEARTBEAT):
        return published
    return see.has_text(recording, HEARTBEAT)


@criterion(points=2, title="The heartbeat is published at 1 Hz: 60 times a minute", needs=[heartbeat_topic])
def heartbeat_count(recording: Recording) -> Verdict:
    return in_rhythm(recording, HEARTBEAT)


@criterion(points=1, title="/robot/battery carries Float32", needs=[program_runs])
def battery_topic(recording: Recording) -> Verdict:
    return carries_floats(recording, BATTERY)


@criterion(points=2, title="The charge is published at 0.5 Hz: 30 times a minute", needs=[battery_topic])
def battery_count(recording: Recording) -> Verdict:
    return in_rhythm(recording, BATTERY)


@criterion(points=1, title="/robot/tilt carries Float32", needs=[program_runs])
def tilt_topic(recording: Recording) -> Verdict:
    return carries_floats(recording, TILT)


@criterion(points=2, title="The tilt is published at 5 Hz: 300 times a minute", needs=[tilt_topic])
def tilt_count(recording: Recording) -> Verdict:
    return in_rhythm(recording, TILT)


@criterion(points=1, title="The program is still running at the end", needs=[program_runs])
def alive_at_end(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)


def in_rhythm(recording: Recording, one: Topic) -> Verdict:
    """Check that a topic's messages come evenly, at the required rate, and in the right number over the whole watch."""
    return see.all_of(see.rate(recording, one), see.counts(recording, one), see.keeps_period(recording, one))


def carries_floats(recording: Recording, one: Topic) -> Verdict:
    """Check that the topic exists and that its values were floats.

    `in_rhythm` judges whether the topic has messages.
    """
    published = see.publishes(recording, one)
    if not published.ok or not see.values(recording, one):
        return published
    return see.given_floats(recording, one)
