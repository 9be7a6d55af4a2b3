"""How exercise 08 is judged: status and battery as they arrive, and how the program ends on Ctrl-C."""

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, topic, watching

STATUS = topic("/robot/status", String, hz=1.0)
BATTERY = topic("/robot/battery", Float32, hz=0.5)
WATCH = watching(to_the_end=True)


def drains(recording: Recording) -> Verdict:
    """The charge is lower at the end than at the start."""
    nothing = see.no_message(recording, BATTERY)
    if nothing is not None:
        return nothing
    levels = see.values(recording, BATTERY)
    if len(levels) < 2 or levels[-1] < levels[0]:
        return see.passed("it drains")
    return see.failed(
        f"{levels[0]:.4g} % in the first message and {levels[-1]:.4g} % in the last",
        "a battery that drains a little with every message",
        "The level is set once and never changed, or the change is not kept in self.",
        "Subtract a little from self.battery_level in the callback, then publish what is left.",
    )


@criterion(points=0, title="Your program runs and its node is on the graph")
def program_runs(recording: Recording) -> Verdict:
    return see.program_runs(recording)


@criterion(points=1, title="/robot/battery carries Float32", needs=[program_runs])
def battery_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, BATTERY)


@criterion(
    points=2, title="The charge of the battery really arrives: 0 to 100 %, falling", needs=[battery_topic]
)
def battery_arrives(recording: Recording) -> Verdict:
    return see.all_of(
        see.really_arrives(recording, BATTERY),
        see.finite(recording, BATTERY),
        see.within(recording, BATTERY, 0.0, 100.0, "%"),
        see.never_rises(recording, BATTERY),
        drains(recording),
    )


@criterion(points=2, title="The battery comes at 0.5 Hz", needs=[battery_topic])
def battery_rate(recording: Recording) -> Verdict:
    return see.rate(recording, BATTERY)


@criterion(points=1, title="/robot/status is as it was: String, 1 Hz", needs=[program_runs])
def status_kept(recording: Recording) -> Verdict:
    return see.all_of(
        see.publishes(recording, STATUS),
        see.one_of(recording, STATUS, {"operational", "error"}),
        see.rate(recording, STATUS),
    )


@criterion(points=1, title="The program runs until it is told to end", needs=[program_runs])
def alive_at_end(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)


@criterion(points=3, title="Ctrl-C ends it with exit code 0, without a traceback", needs=[alive_at_end])
def ends_cleanly(recording: Recording) -> Verdict:
    return see.exits_cleanly(recording)
