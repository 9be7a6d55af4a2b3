"""Judge exercise 09 by the program's messages alone, not by how the program is written or how it exits."""

import math

from std_msgs.msg import Float32, Float32MultiArray, String

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, program_runs, topic, watching

WATCH = watching(simulated_seconds=26)

JOINTS = topic("/robot/joint_positions", Float32MultiArray, hz=0.5)
STATUS = topic("/robot/status", String, hz=1.0)
BATTERY = topic("/robot/battery", Float32, hz=0.5)


@criterion(points=2, title="/robot/joint_positions carries Float32MultiArray", needs=[program_runs])
def joint_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, JOINTS)


@criterion(points=1, title="Every message has exactly 12 values", needs=[joint_topic])
def twelve_values(recording: Recording) -> Verdict:
    return see.length(recording, JOINTS, 12)


@criterion(points=1, title="All angles are finite and within ±π rad", needs=[joint_topic])
def finite_in_range(recording: Recording) -> Verdict:
    return see.all_of(see.finite(recording, JOINTS), see.within(recording, JOINTS, -math.pi, math.pi, "rad"))


@criterion(
    points=1, title="At least two joint angles change from one message to the next", needs=[joint_topic]
)
def joints_move(recording: Recording) -> Verdict:
    return see.varies(recording, JOINTS, at_least=2, by=1e-6, what="joint")


@criterion(points=2, title="The joint positions are published at 0.5 Hz", needs=[joint_topic])
def joint_rate(recording: Recording) -> Verdict:
    return see.rate(recording, JOINTS)


@criterion(points=1, title="/robot/status is unchanged: String, 1 Hz", needs=[program_runs])
def status_kept(recording: Recording) -> Verdict:
    return see.all_of(
        see.publishes(recording, STATUS),
        see.one_of(recording, STATUS, {"operational", "error"}),
        see.word_fits_charge(recording, STATUS, BATTERY),
        see.rate(recording, STATUS),
    )


@criterion(
    points=1, title="/robot/battery is unchanged: Float32, 0.5 Hz, 0 to 100, falling", needs=[program_runs]
)
def battery_kept(recording: Recording) -> Verdict:
    return see.all_of(
        see.publishes(recording, BATTERY),
        see.really_arrives(recording, BATTERY),
        see.finite(recording, BATTERY),
        see.within(recording, BATTERY, 0.0, 100.0, "%"),
        see.never_rises(recording, BATTERY),
        see.drains(recording, BATTERY),
        see.rate(recording, BATTERY),
    )


@criterion(points=1, title="The program is still running at the end", needs=[program_runs])
def alive_at_end(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)
