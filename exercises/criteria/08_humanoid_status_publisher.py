"""Judge exercise 08 by the status and battery messages, and by how the program exits on Ctrl-C."""

from itertools import pairwise

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, program_runs, topic, watching

STATUS = topic("/robot/status", String, hz=1.0)
BATTERY = topic("/robot/battery", Float32, hz=0.5)
WATCH = watching(simulated_seconds=36, to_the_end=True)  # the starter's battery is empty after 30 s at most
WORDS = see.Words(__file__)

ENDED_WHEN_EMPTY = WORDS.cause("alive-at-end.empty", ("saw", "expected", "charge"))


@criterion(points=1, title="/robot/battery carries Float32", needs=[program_runs])
def battery_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, BATTERY)


@criterion(points=2, title="The published charge is correct and falls from 100 %", needs=[battery_topic])
def battery_arrives(recording: Recording) -> Verdict:
    return see.all_of(
        see.really_arrives(recording, BATTERY),
        see.finite(recording, BATTERY),
        see.within(recording, BATTERY, 0.0, 100.0, "%"),
        see.never_rises(recording, BATTERY),
        see.drains(recording, BATTERY),
        see.begins_full(recording, BATTERY),
    )


@criterion(points=2, title="The charge is published at 0.5 Hz", needs=[battery_topic])
def battery_rate(recording: Recording) -> Verdict:
    return see.rate(recording, BATTERY)


@criterion(points=1, title="/robot/status works as before: String, 1 Hz", needs=[program_runs])
def status_kept(recording: Recording) -> Verdict:
    return see.all_of(
        see.publishes(recording, STATUS),
        see.one_of(recording, STATUS, {"operational", "error"}),
        see.word_fits_charge(recording, STATUS, BATTERY),
        see.rate(recording, STATUS),
    )


@criterion(points=1, title="The program keeps running until Ctrl-C", needs=[program_runs])
def alive_at_end(recording: Recording) -> Verdict:
    verdict = see.alive_at_end(recording)
    levels = [level for level in see.values(recording, BATTERY) if isinstance(level, float)]
    largest_step = max((before - after for before, after in pairwise(levels)), default=0.0)
    just_empty = levels and levels.count(0.0) < 2 and levels[-1] <= largest_step
    if verdict.cause != "alive-at-end.ended" or not just_empty:
        return verdict
    return ENDED_WHEN_EMPTY.verdict(saw=verdict.saw, expected=verdict.expected, charge=levels[-1])


@criterion(
    points=3,
    title="Ctrl-C ends the program with exit code 0 and no traceback",
    needs=[alive_at_end],
    about_end=True,
)
def ends_cleanly(recording: Recording) -> Verdict:
    return see.exits_cleanly(recording)
