"""How exercise 04 is judged: twenty readings are said to the monitor, and what it makes of them is compared."""

import math
import re
from dataclasses import dataclass

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import Recording, Topic, Verdict, criterion, topic, watching
from workbook.criteria.mishaps import find_mishap

BATTERY_TOPIC, OTHER_TOPIC = "/robot/battery", "/other_robot/battery"
PASSED_ON = topic("/monitor/battery", Float32)
ALARM = topic("/monitor/alarm", String)

# A battery that drains, is changed for a full one, and runs out. Each charge comes once, so that it can be told apart.
READINGS = (
    52.0, 51.5, 51.0, 50.25, 49.5, 100.0, 99.5, 98.75, 98.0, 97.25,
    96.5, math.nan, 95.0, 94.25, 93.5, 12.5, 6.25, 0.0, 88.0, 87.5,
)  # fmt: skip
BAD_PLACE = 11
GOOD = tuple(reading for reading in READINGS if math.isfinite(reading))
OTHERS = (73.0, -40.0, 72.5)

WATCH = watching(
    robot_seconds=5.0,
    wall_seconds=5.0,
    script=[
        see.says(BATTERY_TOPIC, Float32, [(0.5 + 0.1 * n, reading) for n, reading in enumerate(READINGS)]),
        see.says(
            OTHER_TOPIC,
            Float32,
            [(3.2 + 0.1 * n, reading) for n, reading in enumerate(OTHERS)],
            awaited=False,
        ),
    ],
)

_NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:[.,]\d+)?")
_NO_NUMBER = re.compile(r"\bnan\b|not a number", re.IGNORECASE)
JUMPS = {100.0, 12.5, 88.0}
LOW = {12.5, 6.25, 0.0}
LIMITS = {0.0, 100.0}


# --- what came back -----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Answered:
    """What the monitor passed on: readings of its own robot, the bad one, what stands in its place, other robots'."""

    ours: tuple[float, ...]
    bad: int
    instead: float | None
    others: tuple[float, ...]


def passed_on(recording: Recording) -> Answered:
    """Sort out what arrived on /monitor/battery."""
    levels = [level for level in see.values(recording, PASSED_ON) if isinstance(level, float)]
    others = tuple(level for level in levels if level in OTHERS)
    finite = [level for level in levels if math.isfinite(level) and level not in OTHERS]
    instead = None
    if len(finite) == len(GOOD) + 1 and tuple(finite[:BAD_PLACE] + finite[BAD_PLACE + 1 :]) == GOOD:
        instead = finite.pop(BAD_PLACE)
    return Answered(tuple(finite), sum(not math.isfinite(level) for level in levels), instead, others)


@dataclass(frozen=True)
class Alarms:
    """Texts of alarms, by what they are about. `unnamed`: about the bad reading, but without naming it."""

    named: tuple[str, ...]
    unnamed: tuple[str, ...]
    false: tuple[str, ...]
    others: tuple[str, ...]


def alarms(recording: Recording) -> Alarms:
    """Sort out the alarms: by the number that they name, or else by what was said last before they came."""
    found: dict[str, list[str]] = {"named": [], "unnamed": [], "false": [], "others": []}
    for arrival in recording.topic(ALARM.name).arrivals:
        text = str(arrival.value.get("data"))
        found[_about(recording, text, arrival.published)].append(text)
    return Alarms(**{kind: tuple(texts) for kind, texts in found.items()})


def _about(recording: Recording, text: str, wall: float) -> str:
    if _NO_NUMBER.search(text):
        return "named"
    numbers = {float(number.replace(",", ".")) for number in _NUMBER.findall(text)}
    if numbers & set(OTHERS):
        return "others"
    if numbers & (set(GOOD) - {0.0, 100.0}):
        return "false"
    before = [one for one in recording.said if one.wall <= wall]
    last = max(before, key=lambda one: one.wall, default=None)
    if last is None:
        return "false"
    if last.topic == OTHER_TOPIC:
        return "others"
    return "unnamed" if math.isnan(last.value["data"]) else "false"


def shown(level: float) -> str:
    return f"{level:g}"


# --- words for what may be wrong with the order -------------------------------------------------------------

EXPECTED = f"the {len(GOOD)} good readings on {PASSED_ON.name}, each once, in the order in which they came"


def late_publisher(recording: Recording, one: Topic) -> bool:
    """Whether the publisher was made only when readings were coming in already."""
    seen = recording.topic(one.name).publishers
    first_said = min((word.t for word in recording.said), default=0.0)
    return bool(seen) and all(publisher.first_seen > first_said for publisher in seen)


LATE = (
    "The publisher is made in the callback. It takes a moment until others have found it, and what was published "
    "before that is gone.",
    "Make publishers once, in __init__. In the callback, only use them.",
)


def ended_with_an_error(recording: Recording) -> Verdict | None:
    """What ended the program before its time, in words; None if it lived."""
    mishap = find_mishap(recording.process.log, recording.process.program)
    if recording.process.ended_by != "itself" or mishap is None:
        return None
    return see.failed(
        f"Your program had ended by then: {mishap.where}{mishap.error}", "", mishap.because, mishap.try_this
    )


def nothing_came(recording: Recording) -> Verdict:
    """Nothing on /monitor/battery: find out why."""
    asked = {one.durability for one in recording.topic(BATTERY_TOPIC).subscribers}
    if asked == {"transient_local"}:
        return see.failed(
            f"nothing on {PASSED_ON.name}: your subscription asks for transient local",
            EXPECTED,
            "It asks for messages from before it was there, and the sensor keeps none. So the two are not connected.",
            "Give create_subscription() a plain depth, such as 10.",
        )
    if recording.topic(PASSED_ON.name).publishers and late_publisher(recording, PASSED_ON):
        return see.failed(f"nothing on {PASSED_ON.name}", EXPECTED, *LATE)
    if (ended := ended_with_an_error(recording)) is not None:
        return see.failed(
            f"nothing on {PASSED_ON.name}. {ended.saw}", EXPECTED, ended.because, ended.try_this
        )
    return see.failed(
        f"{len(READINGS)} readings were sent to {BATTERY_TOPIC}, and nothing came on {PASSED_ON.name}",
        EXPECTED,
        "Either nobody spins the node, so the callback never runs, or the callback does not publish.",
        "Spin the node with rclpy.spin(node), and publish the good readings inside the callback.",
        about_time=True,
    )


def missing_readings(recording: Recording, ours: tuple[float, ...]) -> Verdict:
    """Some good readings did not come: which, and what that tells."""
    lost = [level for level in GOOD if level not in ours]
    saw = f"{len(GOOD) - len(lost)} of {len(GOOD)} good readings came, the first that is missing is {shown(lost[0])} %"
    if (ended := ended_with_an_error(recording)) is not None:
        return see.failed(f"{saw}. {ended.saw}", EXPECTED, ended.because, ended.try_this)
    if set(lost) <= LIMITS:
        because = (
            "0 and 100 % are charges, too: an empty battery and a full one. The limits belong to the range."
        )
        try_this = "Use <= where you have <: 0.0 <= message.data <= 100.0."
    elif set(lost) <= JUMPS:
        because = "What is missing comes after a jump. A battery that was changed for a full one jumps, too."
        try_this = "Judge each reading for itself: is it a charge from 0 to 100 %?"
    elif set(lost) <= LOW:
        because = "Only low charges are missing. A low charge is bad news, but it is no bad reading."
        try_this = "Pass on all from 0 to 100 %."
    elif lost == [*GOOD[BAD_PLACE:]]:
        because = (
            "Nothing comes after the bad reading: the node ends, or remembers the fault and never forgets it."
        )
        try_this = (
            "Judge each reading for itself, and return from the callback without an error after the alarm."
        )
    elif late_publisher(recording, PASSED_ON) and lost[0] == GOOD[0]:
        because, try_this = LATE
    else:
        because = (
            "The node was busy or asleep while they came, and the queue was too short; or a timer passes on what came "
            "last, and what came before that is forgotten."
        )
        try_this = (
            "Publish inside the callback, at once, keep it short, and give the subscription a depth of 10."
        )
    return see.failed(saw, EXPECTED, because, try_this, about_time=True)


def changed_or_mixed(ours: tuple[float, ...]) -> Verdict:
    """All that came is not what was sent: changed on the way, twice, or in another order."""
    strange = [level for level in ours if level not in GOOD]
    twice = [level for level in dict.fromkeys(ours) if ours.count(level) > 1 and level in GOOD]
    if ours and set(ours) == {0.0}:
        return see.failed(
            f"0 in each of the {len(ours)} messages on {PASSED_ON.name}",
            EXPECTED,
            "The message is never filled, or is given no Python float: stock ROS sends an int as 0.0, without a word.",
            "Pass on message.data as it is: Float32(data=message.data), or publish the message itself.",
        )
    if strange:
        near = min(GOOD, key=lambda level: abs(level - strange[0]))
        return see.failed(
            f"{shown(strange[0])} on {PASSED_ON.name}, which nobody sent; {shown(near)} was sent",
            EXPECTED,
            "The reading is changed on the way: rounded, averaged, limited or computed from others.",
            "Pass on message.data as it is.",
        )
    if twice:
        return see.failed(
            f"{shown(twice[0])} came {ours.count(twice[0])} times on {PASSED_ON.name}",
            EXPECTED,
            "Two subscriptions hear the same topic, or a timer sends the last reading again.",
            "One subscription, and one publish for each call of the callback.",
        )
    place = next(n for n, (one, other) in enumerate(zip(ours, GOOD, strict=False)) if one != other)
    return see.failed(
        f"{shown(ours[place])} came where {shown(GOOD[place])} should be, as reading {place + 1}",
        EXPECTED,
        "Readings are collected and sent in another order, such as the newest first or sorted.",
        "Publish each one inside the callback, at once: it is called in the right order.",
    )


# --- the criteria -------------------------------------------------------------------------------------------


@criterion(points=0, title="Your program runs and its node is on the graph")
def program_runs(recording: Recording) -> Verdict:
    return see.program_runs(recording)


@criterion(points=1, title="It listens to /robot/battery, type Float32", needs=[program_runs])
def listens(recording: Recording) -> Verdict:
    return see.listens(recording, topic(BATTERY_TOPIC, Float32))


@criterion(points=1, title="/monitor/battery carries Float32", needs=[program_runs])
def battery_topic(recording: Recording) -> Verdict:
    verdict = see.publishes(recording, PASSED_ON)
    if not verdict.ok and recording.topic(BATTERY_TOPIC).publishers:
        return see.failed(
            f"your node publishes {BATTERY_TOPIC}, and nothing on {PASSED_ON.name}",
            verdict.expected,
            "It publishes where it listens. So it hears itself, answers itself, and so on without end.",
            f"Write the name as {PASSED_ON.name!r}.",
        )
    return verdict


@criterion(
    points=2, title="All 19 good readings are passed on, in the right order", needs=[listens, battery_topic]
)
def in_order(recording: Recording) -> Verdict:
    ours = passed_on(recording).ours
    if ours == GOOD:
        return see.passed(f"{len(GOOD)} good readings, from {shown(GOOD[0])} to {shown(GOOD[-1])}, in order")
    if not ours:
        return nothing_came(recording)
    if set(ours) <= set(GOOD) and not set(GOOD) <= set(ours) and set(ours) != {0.0}:
        return missing_readings(recording, ours)
    return changed_or_mixed(ours)


@criterion(points=1, title="The bad reading is not passed on", needs=[in_order])
def bad_kept_back(recording: Recording) -> Verdict:
    answered = passed_on(recording)
    expected = f"nothing on {PASSED_ON.name} for the bad reading"
    if answered.bad:
        return see.failed(
            f"nan on {PASSED_ON.name}, behind {shown(GOOD[BAD_PLACE - 1])}",
            expected,
            "nan is not a number: nan < 0 is False, nan > 100 is False, and nan == nan is False, too. So it slips "
            "through any test that asks for what is bad.",
            "Ask for what is good: 0.0 <= message.data <= 100.0 is False for nan. Or ask math.isnan(message.data).",
        )
    if answered.instead is not None:
        return see.failed(
            f"{shown(answered.instead)} on {PASSED_ON.name} in place of the bad reading",
            expected,
            "The node makes up a reading. Whoever listens takes it for measured.",
            "Raise the alarm, and publish nothing on this topic.",
        )
    return see.passed("nothing came in its place")


@criterion(points=1, title="/monitor/alarm carries String", needs=[program_runs])
def alarm_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, ALARM)


@criterion(points=2, title="One alarm for the bad reading, naming it", needs=[listens, alarm_topic])
def one_alarm(recording: Recording) -> Verdict:
    found = alarms(recording)
    expected = f'exactly one text on {ALARM.name} for the bad reading, with its value in it: "nan"'
    about_it = (*found.named, *found.unnamed)
    if len(about_it) > 1:
        return see.failed(
            f'{len(about_it)} alarms for one bad reading, the first is "{about_it[0][:60]}"',
            expected,
            "The alarm is published in a timer or a loop, or by more than one subscription.",
            "Publish it inside the callback, once for each bad reading.",
        )
    if found.named:
        return see.passed(f'the alarm says "{found.named[0][:60]}"')
    if found.unnamed:
        return see.partial(
            0.5,
            f'the alarm says "{found.unnamed[0][:60]}" and not which value it is about',
            expected,
            "Somebody has to find the fault by this text, and the value is the best clue.",
            'Put the value in: String(data=f"bad battery reading: {message.data}").',
        )
    if recording.topic(ALARM.name).publishers and late_publisher(recording, ALARM):
        return see.failed(f"no alarm arrived on {ALARM.name}", expected, *LATE)
    if (ended := ended_with_an_error(recording)) is not None:
        return see.failed(
            f"no alarm for the bad reading. {ended.saw}", expected, ended.because, ended.try_this
        )
    if len(set(GOOD) - set(passed_on(recording).ours)) > len(LOW):
        return see.failed(
            "no alarm for the bad reading",
            expected,
            "Good readings are missing, too: perhaps your callback never got the bad one.",
            "See first that all good readings are passed on.",
            about_time=True,
        )
    return see.failed(
        "no alarm for the bad reading, which was nan",
        expected,
        "nan is not a number, and every comparison with it is False: nan < 0, nan > 100, and even nan == nan.",
        "Ask whether the reading is good, 0.0 <= message.data <= 100.0, and raise the alarm if it is not.",
    )


@criterion(points=1, title="No alarm for good readings", needs=[one_alarm])
def no_false_alarm(recording: Recording) -> Verdict:
    false = alarms(recording).false
    if not false:
        return see.passed("none")
    because = "Readings from 0 to 100 % are good, both limits included, whatever came before them."
    try_this = "Decide by this one reading: 0.0 <= message.data <= 100.0."
    if any(shown(level) in false[0] for level in LOW if level):
        because = "A low battery is bad news, but it is no bad reading."
    elif len(false) > len(LOW):
        because = "Once the alarm has been raised, it is raised for what comes after it, too."
    return see.failed(
        f'{len(false)} alarm{"s" if len(false) > 1 else ""} too many, the first is "{false[0][:60]}"',
        f"no alarm for the {len(GOOD)} good readings",
        because,
        try_this,
    )


@criterion(points=1, title="It is silent about /other_robot/battery", needs=[in_order])
def own_robot_only(recording: Recording) -> Verdict:
    others, about_them = passed_on(recording).others, alarms(recording).others
    if not others and not about_them:
        return see.passed(f"{len(OTHERS)} readings of another robot, and not a word")
    saw = f"{shown(others[0])} on {PASSED_ON.name}" if others else f'the alarm "{about_them[0][:60]}"'
    return see.failed(
        f"{saw}: that is a reading of {OTHER_TOPIC}",
        f"readings of {BATTERY_TOPIC} only",
        "The node subscribes to more than its own robot's battery.",
        f"One subscription, to {BATTERY_TOPIC!r}.",
    )
