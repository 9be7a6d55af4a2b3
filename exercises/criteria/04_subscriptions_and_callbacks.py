"""How exercise 04 is judged: good and bad readings are said to the monitor, and its answers are compared."""

import math
import re
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher
from functools import lru_cache
from itertools import pairwise

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import Recording, Topic, Verdict, criterion, program_runs, topic, watching

BATTERY_TOPIC, OTHER_TOPIC = "/robot/battery", "/other_robot/battery"
PASSED_ON = topic("/monitor/battery", Float32)
ALARM = topic("/monitor/alarm", String)

AT_ONCE_S = 0.5  # the task names it
SHARE_AT_ONCE = 0.9  # of the readings: the others may have been kept waiting by a busy machine

# A battery that drains, is changed for a full one, runs out, and is changed again. In between the cable shakes.
BEFORE_PAUSE = (52.0, 51.5, 51.0, 51.0, 50.25, 49.5)
AFTER_PAUSE = (
    49.25, -3.0, -3.0, 48.75, 100.0, 99.5, 98.75, 98.0, 97.25, 96.5, math.nan, 95.0, 94.25, 93.5, 120.0, math.inf,
    math.nan, 92.75, 12.5, 6.25, 0.375, 0.0, -0.125, 88.0, 87.5, 100.0001220703125, 87.25,
)  # fmt: skip
AT_THE_SAME_MOMENT = (86.75, 86.5, 86.25, 85.75)
AT_THE_END = (
    85.5, 2e9, 85.25, 84.5, 84.5, 84.25, 83.75, -0.0001220703125, 83.5, 82.75, -math.inf, 81.5, 80.25, 79.75, 78.5,
    77.25, 120.0,
)  # fmt: skip
READINGS = (*BEFORE_PAUSE, *AFTER_PAUSE, *AT_THE_SAME_MOMENT, *AT_THE_END)
OTHERS = (73.0, -40.0, 72.5)  # not among the readings: an answer that passes one on has heard the other robot
BEGIN_S, APART_S, SAME_MOMENT_S = 0.5, 0.1, 0.01
PAUSE_S, OTHERS_AFTER_S = 1.0, 0.55


def is_good(reading: float) -> bool:
    return 0.0 <= reading <= 100.0


GOOD_PLACES = tuple(place for place, reading in enumerate(READINGS) if is_good(reading))
BAD_PLACES = tuple(place for place, reading in enumerate(READINGS) if not is_good(reading))
GOOD = tuple(READINGS[place] for place in GOOD_PLACES)
BAD = tuple(READINGS[place] for place in BAD_PLACES)
BELOW, ABOVE = {one for one in BAD if one < 0.0}, {one for one in BAD if one > 100.0}
NEAR_LIMITS = {-0.125, -0.0001220703125, 100.0001220703125}
LIMITS = {0.0, 100.0}
INSIDE = tuple(reading for reading in GOOD if reading not in LIMITS)
LOW_AT_MOST = 20.0

# What some of the good readings have in common, by their places among the good ones.
AFTER_BAD = {n for n, place in enumerate(GOOD_PLACES) if place and not is_good(READINGS[place - 1])}
EQUAL_TO_LAST = {n for n, (last, one) in enumerate(pairwise(GOOD), 1) if last == one}
JUMPS = {n for n, (last, one) in enumerate(pairwise(GOOD), 1) if abs(last - one) > 10.0}
IN_A_MOMENT = {GOOD.index(reading) for reading in AT_THE_SAME_MOMENT}
LOW = {n for n, reading in enumerate(GOOD) if reading <= LOW_AT_MOST}
FIRST_AFTER_BAD = min(AFTER_BAD)
RISEN = {n for n, reading in enumerate(GOOD) if n and reading > min(GOOD[:n])}
SAID_BEFORE = {n for n, one in enumerate(BAD) if any(repr(one) == repr(other) for other in BAD[:n])}
BAD_IN_A_ROW = {n for n, (last, one) in enumerate(pairwise(BAD_PLACES), 1) if one == last + 1}


def readings_with_times() -> list[tuple[float, float]]:
    """Each reading with the moment (s of robot time) at which it is said."""
    lines, at = [], BEGIN_S
    for group, apart, pause in (
        (BEFORE_PAUSE, APART_S, PAUSE_S),
        (AFTER_PAUSE, APART_S, 0.0),
        (AT_THE_SAME_MOMENT, SAME_MOMENT_S, APART_S),
        (AT_THE_END, APART_S, 0.0),
    ):
        for reading in group:
            lines.append((round(at, 2), reading))
            at += apart
        at += pause
    return lines


SAID_AT = readings_with_times()
PAUSE_BEGINS_S, LAST_AT_S = SAID_AT[len(BEFORE_PAUSE) - 1][0], SAID_AT[-1][0]
WATCH_S = LAST_AT_S + 1.4  # a timer that repeats the last alarm each second does so in this time

WATCH = watching(
    robot_seconds=WATCH_S,
    wall_seconds=WATCH_S,
    script=[
        see.says(BATTERY_TOPIC, Float32, SAID_AT),
        see.says(
            OTHER_TOPIC,
            Float32,
            [
                (PAUSE_BEGINS_S + OTHERS_AFTER_S, OTHERS[0]),
                (PAUSE_BEGINS_S + OTHERS_AFTER_S + 0.1, OTHERS[1]),
                (LAST_AT_S + 0.4, OTHERS[2]),
            ],
            awaited=False,
        ),
    ],
)

LONGEST_QUOTE = 60  # characters of an alarm that feedback quotes


@criterion(points=1, title="It listens to /robot/battery, type Float32", needs=[program_runs])
def listens(recording: Recording) -> Verdict:
    return see.listens(recording, topic(BATTERY_TOPIC, Float32))


@criterion(points=1, title="/monitor/battery carries Float32", needs=[program_runs])
def battery_topic(recording: Recording) -> Verdict:
    verdict = see.publishes(recording, PASSED_ON)
    if not verdict.ok and recording.topic(BATTERY_TOPIC).publishers:
        return see.failed(
            "battery-topic.publishes-where-it-listens",
            f"your node publishes {BATTERY_TOPIC}, and nothing on {PASSED_ON.name}",
            verdict.expected,
            "It publishes on the topic that it subscribes to. So it receives its own messages, and each one "
            "causes another, without end.",
            f"Write the name as {PASSED_ON.name!r}.",
        )
    return verdict


@criterion(points=0, title="It passes readings on", needs=[listens, battery_topic])
def passes_on(recording: Recording) -> Verdict:
    if see.values(recording, PASSED_ON):
        return see.passed("readings come")
    return why_nothing_came(recording)


@criterion(points=2, title="All good readings are passed on, at once, in the right order", needs=[passes_on])
def in_order(recording: Recording) -> Verdict:
    answered = passed_on(recording)
    if answered.ours == GOOD:
        return at_once(recording)
    if answered.extra:
        return why_others_came(answered)
    return why_some_are_missing(recording, answered.lost)


@criterion(points=1, title="No bad reading is passed on, and nothing is sent in its place", needs=[passes_on])
def bad_kept_back(recording: Recording) -> Verdict:
    answered = passed_on(recording)
    if answered.instead and set(answered.instead) <= LIMITS:
        return see.failed(
            "bad-kept-back.clamped",
            f"{shown(answered.instead[0])} on {PASSED_ON.name} in place of a bad reading",
            NO_BAD_ONES,
            "A bad reading is replaced by the nearest limit. A subscriber will think that this value was measured.",
            "Raise the alarm, and publish nothing on this topic.",
        )
    if answered.instead:
        return see.failed(
            "bad-kept-back.replaced",
            f"{shown(answered.instead[0])} on {PASSED_ON.name} in place of a bad reading",
            NO_BAD_ONES,
            "The node makes up a reading. A subscriber will think that it was measured.",
            "Raise the alarm, and publish nothing on this topic.",
        )
    if len(answered.bad) > sum(map(math.isnan, BAD)) and all(map(math.isnan, answered.bad)):
        return see.failed(
            "bad-kept-back.nan-instead",
            f"{len(answered.bad)} times nan on {PASSED_ON.name}, more often than it was sent",
            NO_BAD_ONES,
            "The node publishes a nan in place of other bad readings. A subscriber that compares it with a limit is "
            "misled: each comparison with nan is False.",
            "Raise the alarm, and publish nothing on this topic.",
        )
    if answered.bad:
        return why_bad_ones_came(answered.bad)
    return see.passed("no bad reading was passed on, and nothing was sent in its place")


@criterion(points=1, title="/monitor/alarm carries String", needs=[program_runs])
def alarm_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, ALARM)


@criterion(points=0, title="It raises alarms", needs=[listens, alarm_topic])
def alarms_come(recording: Recording) -> Verdict:
    if recording.topic(ALARM.name).arrivals:
        return see.passed("alarms come")
    return why_no_alarm_came(recording)


@criterion(points=2, title="One alarm for each bad reading, with its value", needs=[alarms_come])
def one_alarm(recording: Recording) -> Verdict:
    found = alarms(recording)
    if found.misnamed:
        return why_not_named(found.misnamed)
    if len(found.repeated) > len(found.missed):
        return see.failed(
            "one-alarm.repeated",
            f"{len(found.repeated)} alarms too many for bad readings, the first is {quoted(found.repeated[0])}",
            ONE_EACH,
            "The alarm is published in a timer or a loop, more than once in the callback, or by more than one "
            "subscription.",
            "Publish it inside the callback, once for each bad reading.",
        )
    if found.missed:
        return why_alarms_are_missing(recording, found.missed)
    return see.passed(f"{len(BAD)} alarms for {len(BAD)} bad readings")


@criterion(points=1, title="No alarm for good readings", needs=[alarms_come])
def no_false_alarm(recording: Recording) -> Verdict:
    found = alarms(recording)
    return why_false_alarms(found) if found.false else see.passed("none")


@criterion(points=1, title="It ignores /other_robot/battery", needs=[passes_on])
def own_robot_only(recording: Recording) -> Verdict:
    others, about_them = passed_on(recording).others, alarms(recording).others
    if not others and not about_them:
        return see.passed(f"{len(OTHERS)} readings of another robot, and none was passed on or reported")
    saw = f"{shown(others[0])} on {PASSED_ON.name}" if others else f"the alarm {quoted(about_them[0])}"
    return see.failed(
        "own-robot-only.hears-others",
        f"{saw}: that is a reading of {OTHER_TOPIC}",
        f"readings of {BATTERY_TOPIC} only",
        "The node subscribes to more than its own robot's battery.",
        f"One subscription, to {BATTERY_TOPIC!r}.",
    )


# --- what came back -----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Answered:
    """What the monitor passed on.

    `ours`: readings of its own robot from 0 to 100 %. `lost`: which of the good ones did not come, by their places
    among them. `extra`: what came and was not sent. `instead`: what came in the place of bad readings.
    """

    ours: tuple[float, ...]
    lost: tuple[int, ...]
    extra: tuple[float, ...]
    instead: tuple[float, ...]
    bad: tuple[float, ...]
    others: tuple[float, ...]


@see.once
def passed_on(recording: Recording) -> Answered:
    """Sort out what arrived on /monitor/battery."""
    levels = [level for level in see.values(recording, PASSED_ON) if isinstance(level, float)]
    others = tuple(level for level in levels if level in OTHERS)
    bad = tuple(level for level in levels if not is_good(level) and level not in OTHERS)
    good = [level for level in levels if is_good(level) and level not in OTHERS]
    lost: list[int] = []
    extra: list[float] = []
    instead: list[float] = []
    ours: list[float] = []
    for kind, i, end, j, to in SequenceMatcher(None, GOOD, good, autojunk=False).get_opcodes():
        came = good[j:to]
        if kind == "insert" and len(came) <= bad_before(behind_equals(i, came)):
            instead += came
            continue
        ours += came
        if kind != "equal":
            lost += range(i, end)
            extra += came
    if instead and extra:  # more than the bad readings brings something that was not sent
        return Answered(tuple(good), tuple(lost), (*instead, *extra), (), bad, others)
    return Answered(tuple(ours), tuple(lost), tuple(extra), tuple(instead), bad, others)


def behind_equals(place: int, came: list[float]) -> int:
    """Where what came may stand as well: behind good readings that it is equal to."""
    while place < len(GOOD) and {GOOD[place]} == set(came):
        place += 1
    return place


def bad_before(place: int) -> int:
    """How many bad readings were said between the good one at `place` and the one before."""
    last = GOOD_PLACES[place - 1] if place else -1
    here = GOOD_PLACES[place] if place < len(GOOD) else len(READINGS)
    return here - last - 1


def at_once(recording: Recording) -> Verdict:
    """All good readings came in order; whether they came at once."""
    said_at = [word.t for word in see.said(recording, BATTERY_TOPIC) if is_good(word.value["data"])]
    came_at = moments_of_good_ones(recording)
    late = late_ones(recording)
    if len(came_at) != len(said_at) or len(late) <= (1.0 - SHARE_AT_ONCE) * len(said_at):
        return see.passed(f"{len(GOOD)} good readings, from {shown(GOOD[0])} to {shown(GOOD[-1])}, in order")
    return see.failed(
        "in-order.late",
        f"{len(late)} of {len(GOOD)} good readings came late, one of them after {max(late):.1f} s",
        f"each good reading on {PASSED_ON.name} within {AT_ONCE_S} s",
        "Readings are collected and sent later, by a timer or in groups. Or the callback sleeps.",
        "Publish each one inside the callback, at once.",
        about_time=True,
    )


def moments_of_good_ones(recording: Recording) -> list[float]:
    """When good readings arrived on /monitor/battery (s)."""
    return [
        arrival.t
        for arrival in recording.topic(PASSED_ON.name).arrivals
        if arrival.value["data"] in GOOD and arrival.value["data"] not in OTHERS
    ]


def late_ones(recording: Recording) -> list[float]:
    """How late (s) those good readings came that came late, if none is missing before the last one that came."""
    said_at = [word.t for word in see.said(recording, BATTERY_TOPIC) if is_good(word.value["data"])]
    delays = [came - said for said, came in zip(said_at, moments_of_good_ones(recording), strict=False)]
    return [delay for delay in delays if delay > AT_ONCE_S]


def come_in_groups(recording: Recording) -> bool:
    """Whether most good readings arrived at the same moment as another one."""
    came_at = moments_of_good_ones(recording)
    return 3 * sum(after - before > APART_S / 2 for before, after in pairwise(came_at)) < len(came_at)


@dataclass(frozen=True)
class Alarms:
    """Texts of alarms, by what they are about.

    `missed`: the bad readings without one, by their places among the bad ones. `misnamed`: such a place, and the text
    that came for it, where there is one alarm for each bad reading. `before_bad`: whether a false one came before the
    first bad reading.
    """

    missed: tuple[int, ...]
    misnamed: tuple[tuple[int, str], ...]
    repeated: tuple[str, ...]
    false: tuple[str, ...]
    others: tuple[str, ...]
    before_bad: bool = False


@see.once
def alarms(recording: Recording) -> Alarms:
    """Sort out the alarms: by the value that they name, or else by what was said last before they came."""
    sent = [(str(one.value.get("data")), one.published) for one in recording.topic(ALARM.name).arrivals]
    about_others = [is_about_others(recording, text, at) for text, at in sent]
    others = [text for (text, _), other in zip(sent, about_others, strict=True) if other]
    own = [one for one, other in zip(sent, about_others, strict=True) if not other]
    pairs = told_apart([text for text, _ in own])
    missed = tuple(sorted(set(range(len(BAD))) - pairs.keys()))
    named = set(pairs.values())
    rest = [one for n, one in enumerate(own) if n not in named]
    after_bad = [one for one in rest if not is_good(last_reading(recording, one[1]))]
    if missed and len(own) == len(BAD) and 2 * len(after_bad) > len(rest):
        misnamed = tuple((place, own[place][0]) for place in range(len(BAD)) if pairs.get(place) != place)
        return Alarms((), misnamed, (), (), tuple(others))
    due = {own[n][0] for n in pairs.values()}
    false = [one for one in rest if is_false(recording, *one, due)]
    set_of_false = set(false)
    first_bad = min(
        (word.wall for word in see.said(recording, BATTERY_TOPIC) if not is_good(word.value["data"])),
        default=math.inf,
    )
    return Alarms(
        missed,
        (),
        tuple(text for text, at in rest if (text, at) not in set_of_false),
        tuple(text for text, _ in false),
        tuple(others),
        any(at < first_bad for _, at in false),
    )


def told_apart(texts: Sequence[str]) -> dict[int, int]:
    """As `in_turn`, without the texts that are the same for different readings: they name no reading."""
    pairs = in_turn(texts)
    about: dict[str, set[str]] = {}
    for reading, text in pairs.items():
        about.setdefault(texts[text], set()).add(repr(BAD[reading]))
    return {reading: text for reading, text in pairs.items() if len(about[texts[text]]) == 1}


def in_turn(texts: Sequence[str]) -> dict[int, int]:
    """For as many bad readings as possible, in their order, a text that names it: place of the reading, of the text."""
    named = [[names(text, reading) for reading in BAD] for text in texts]
    longest = [[0] * (len(texts) + 1) for _ in range(len(BAD) + 1)]
    for i in reversed(range(len(BAD))):
        for j in reversed(range(len(texts))):
            both = longest[i + 1][j + 1] + 1 if named[j][i] else 0
            longest[i][j] = max(both, longest[i + 1][j], longest[i][j + 1])
    pairs, i, j = {}, 0, 0
    while i < len(BAD) and j < len(texts):
        if named[j][i] and longest[i][j] == longest[i + 1][j + 1] + 1:
            pairs[i] = j
            i, j = i + 1, j + 1
        elif longest[i][j] == longest[i][j + 1]:
            j += 1
        else:
            i += 1
    return pairs


_NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:[.,]\d+)?(?:[eE][-+]?\d+)?")
_IN_GROUPS = re.compile(r"(?<![\w.,])[-+]?\d{1,3}(?:,\d{3})+(?:\.\d+)?(?![\d,])")
_NO_NUMBER = re.compile(r"\bnan\b|not a number", re.IGNORECASE)
_INFINITE = re.compile(r"(-|\bminus |\bnegative |)\binf(?:inity|inite)?\b", re.IGNORECASE)
AS_ROUNDED = 0.05 + 1e-6  # an alarm may give its value with one decimal


@lru_cache(maxsize=1)  # a text is asked for one number after the other
def numbers_in(text: str) -> list[float]:
    """The numbers in an alarm, also with a decimal comma, with an exponent, or with commas between the thousands."""
    in_groups = [float(number.replace(",", "")) for number in _IN_GROUPS.findall(text)]
    return [float(number.replace(",", ".")) for number in _NUMBER.findall(text)] + in_groups


def names(text: str, reading: float) -> bool:
    """Whether an alarm names a reading."""
    if math.isnan(reading):
        return bool(_NO_NUMBER.search(text))
    if math.isinf(reading):
        return any(bool(found.group(1)) == (reading < 0.0) for found in _INFINITE.finditer(text))
    return any(abs(number - reading) <= AS_ROUNDED for number in numbers_in(text))


def names_one_of(readings: Sequence[float], text: str) -> bool:
    return any(names(text, reading) for reading in readings)


def is_about_others(recording: Recording, text: str, published: float) -> bool:
    """Whether an alarm is about the other robot. `published`: its wall time (s)."""
    if set(numbers_in(text)) & set(OTHERS):
        return True
    if names_one_of(BAD, text):
        return False
    last = see.latest_before(((one.wall, one) for one in recording.said), published)
    return last is not None and last.topic == OTHER_TOPIC


def last_reading(recording: Recording, published: float) -> float:
    """The reading that was said last before an alarm was published; 0 before the first one."""
    last = see.latest_before(((one.wall, one) for one in see.said(recording, BATTERY_TOPIC)), published)
    return 0.0 if last is None else float(last.value["data"])


def is_false(recording: Recording, text: str, published: float, due: Collection[str]) -> bool:
    """Whether an alarm is about a good reading. `due`: the texts that are one alarm for each bad reading."""
    last = last_reading(recording, published)
    if names_one_of(BAD, text):
        return is_good(last) and (text not in due or names(text, last))
    # 0 and 100 are no proof: an alarm may name the limits.
    if set(numbers_in(text)) & (set(GOOD) - LIMITS):
        return True
    return is_good(last)


def shown(level: float) -> str:
    return f"{level:.7g}"


def quoted(alarm: str) -> str:
    return f'"{alarm[:LONGEST_QUOTE]}"'


# --- why readings do not come as they were sent -------------------------------------------------------------

EXPECTED = f"the {len(GOOD)} good readings on {PASSED_ON.name}, each once, in the order in which they came"
NO_BAD_ONES = f"nothing on {PASSED_ON.name} for a bad reading"


def why_nothing_came(recording: Recording) -> Verdict:
    """Why nothing arrived on /monitor/battery."""
    nothing = f"nothing on {PASSED_ON.name}"
    asked = {one.durability for one in recording.topic(BATTERY_TOPIC).subscribers}
    if asked == {"transient_local"}:
        return see.failed(
            "in-order.asks-for-old-messages",
            f"{nothing}: your subscription asks for transient local",
            EXPECTED,
            "It asks for messages that were published before it existed, but the sensor keeps none. So the two "
            "are not connected.",
            "Give create_subscription() a plain depth, such as 10.",
        )
    if made_late(recording, PASSED_ON):
        return see.failed("in-order.publisher-made-late", nothing, EXPECTED, *MADE_LATE)
    return ended_with_an_error(recording, nothing, EXPECTED) or see.failed(
        "in-order.nothing-passed-on",
        f"{len(READINGS)} readings were sent to {BATTERY_TOPIC}, and nothing came on {PASSED_ON.name}",
        EXPECTED,
        "Either nothing spins the node, so the callback never runs, or the callback does not publish.",
        "Spin the node with rclpy.spin(node), and publish the good readings inside the callback.",
        about_time=True,
    )


def why_some_are_missing(recording: Recording, lost: tuple[int, ...]) -> Verdict:
    """Why these good readings, by their places, did not come."""
    came = len(GOOD) - len(lost)
    saw = f"{came} of {len(GOOD)} good readings came; the first missing one is {shown(GOOD[lost[0]])} %"
    return (
        ended_with_an_error(recording, saw, EXPECTED)
        or kept_back_for_its_value(saw, set(lost))
        or kept_back_for_what_came_before(recording, saw, set(lost))
        or lost_on_the_way(recording, saw, lost)
    )


def kept_back_for_its_value(saw: str, lost: set[int]) -> Verdict | None:
    """Why the monitor did not want readings of such values; None if they have none in common."""
    if {GOOD[place] for place in lost} <= LIMITS:
        return see.failed(
            "in-order.limits-kept-back",
            saw,
            EXPECTED,
            "0 and 100 % are good readings, too: an empty battery and a full one. The limits belong to the range.",
            "Use <= where you have <: 0.0 <= message.data <= 100.0.",
            about_time=True,
        )
    if lost <= LOW:
        return see.failed(
            "in-order.low-kept-back",
            saw,
            EXPECTED,
            "Only low charges are missing. A low charge is bad news, but it is not a bad reading.",
            "Pass on all from 0 to 100 %.",
            about_time=True,
        )
    return None


def kept_back_for_what_came_before(recording: Recording, saw: str, lost: set[int]) -> Verdict | None:
    """Why the monitor did not want these readings after those before them; None if nothing says so."""
    came = passed_on(recording).ours
    if came == all_but(AFTER_BAD):
        return see.failed(
            "in-order.after-bad-kept-back",
            saw,
            EXPECTED,
            "The missing readings came directly after a bad one. Whether a reading is good depends on that "
            "reading alone.",
            EACH_FOR_ITSELF,
            about_time=True,
        )
    if came == all_but(EQUAL_TO_LAST):
        return see.failed(
            "in-order.equal-kept-back",
            saw,
            EXPECTED,
            "The missing readings are equal to the ones before them. A charge may stay the same.",
            "Pass on each good reading, no matter what came before it.",
            about_time=True,
        )
    return jumps_or_stops(saw, lost) or taken_for_bad(recording, saw, lost) or risen_kept_back(saw, lost)


def jumps_or_stops(saw: str, lost: set[int]) -> Verdict | None:
    """Whether the monitor kept back what came after a jump, or all after a bad reading."""
    if lost <= JUMPS:
        return see.failed(
            "in-order.jumps-kept-back",
            saw,
            EXPECTED,
            "The missing readings come after a jump. But the charge also jumps when an empty battery is replaced "
            "by a full one.",
            EACH_FOR_ITSELF,
            about_time=True,
        )
    if lost == {*range(FIRST_AFTER_BAD, len(GOOD))}:
        return see.failed(
            "in-order.stops-at-the-bad-one",
            saw,
            EXPECTED,
            "Nothing comes after the first bad reading: the node ends, or it remembers the fault, forever or for a "
            "while.",
            "Judge each reading on its own, and return from the callback without an error after the alarm.",
            about_time=True,
        )
    return None


def risen_kept_back(saw: str, lost: set[int]) -> Verdict | None:
    """Whether the monitor kept back all that is higher than a reading before it, from some reading on."""
    since = set(range(min(lost), len(GOOD)))
    if lost != RISEN & since or lost == since:
        return None
    return see.failed(
        "in-order.risen-kept-back",
        saw,
        EXPECTED,
        "All missing readings are higher than one that came before. But the charge rises when an empty battery is "
        "replaced by a full one.",
        EACH_FOR_ITSELF,
        about_time=True,
    )


def taken_for_bad(recording: Recording, saw: str, lost: set[int]) -> Verdict | None:
    """Whether the monitor raised alarms about the readings that are missing."""
    alarmed = alarms(recording).false
    of_them = [GOOD[place] for place in sorted(lost) if any(names(text, GOOD[place]) for text in alarmed)]
    if of_them and 2 * len(of_them) > len(lost):
        return see.failed(
            "in-order.taken-for-bad",
            f"{saw}; there is an alarm about {shown(of_them[0])} %",
            EXPECTED,
            "The node treats good readings as bad. Perhaps it compares each one with the one before.",
            EACH_FOR_ITSELF,
            about_time=True,
        )
    return None


EACH_FOR_ITSELF = "Judge each reading on its own: is it a charge from 0 to 100 %?"


def all_but(places: set[int]) -> tuple[float, ...]:
    """The good readings without those at these places."""
    return tuple(reading for n, reading in enumerate(GOOD) if n not in places)


def lost_on_the_way(recording: Recording, saw: str, lost: tuple[int, ...]) -> Verdict:
    """Why these readings are missing, if not for what they say."""
    if recording.process.ended_by == "itself" and lost == tuple(range(lost[0], len(GOOD))):
        return see.failed(
            "in-order.ended",
            f"{saw}. Your program had already ended",
            EXPECTED,
            "The program ends by itself after a while.",
            "Spin until the program is stopped: rclpy.spin(node).",
            about_time=True,
        )
    if made_late(recording, PASSED_ON) and lost[0] == 0:
        return see.failed("in-order.first-ones-lost", saw, EXPECTED, *MADE_LATE, about_time=True)
    return lost_at_an_end(saw, lost) or none_from_one_on(recording, saw, lost) or lost_among_others(saw, lost)


def none_from_one_on(recording: Recording, saw: str, lost: tuple[int, ...]) -> Verdict | None:
    """Why all came up to one reading, and none from it on; None if it is not so, or if many of them came late."""
    if lost != tuple(range(lost[0], len(GOOD))):
        return None
    late = late_ones(recording)
    if len(late) <= (1.0 - SHARE_AT_ONCE) * lost[0]:
        return see.failed(
            "in-order.stops",
            saw,
            EXPECTED,
            "All readings before it came at once, and none from it on. So the node counts readings or alarms, it "
            "remembers an error, a callback never returns, or nothing spins the node any more.",
            "Treat every reading the same, let the callback return, and spin until the program is stopped.",
            about_time=True,
        )
    if come_in_groups(recording):
        return see.failed(
            "in-order.in-groups",
            f"{saw}, and {len(late)} of the others came late, one of them after {max(late):.1f} s",
            EXPECTED,
            "Readings are collected and sent in groups, and the last group was not full.",
            "Publish each one inside the callback, at once.",
            about_time=True,
        )
    return None


def lost_at_an_end(saw: str, lost: tuple[int, ...]) -> Verdict | None:
    """Why only the first or only the last one is missing; None if it is not so."""
    if lost == (0,):
        return see.failed(
            "in-order.first-one-lost",
            saw,
            EXPECTED,
            "Only the first reading is missing. The node skips it, or uses it for something else.",
            "Pass on each good reading, the first one, too.",
            about_time=True,
        )
    if lost == (len(GOOD) - 1,):
        return see.failed(
            "in-order.held-back",
            saw,
            EXPECTED,
            "Only the last reading is missing. The node keeps each reading until the next one comes.",
            "Publish each one inside the callback, at once.",
            about_time=True,
        )
    return None


def lost_among_others(saw: str, lost: tuple[int, ...]) -> Verdict:
    """Why these are missing, and others came before and after them."""
    if set(lost) <= IN_A_MOMENT:
        return see.failed(
            "in-order.several-at-once-lost",
            saw,
            EXPECTED,
            "The missing readings came directly after another one. The queue was too short for them, or the node "
            "skips what comes too soon.",
            "Give the subscription a depth of 10, and publish in every call of the callback.",
            about_time=True,
        )
    return see.failed(
        "in-order.some-lost",
        saw,
        EXPECTED,
        "The node was busy or asleep while they came, and the queue was too short. Or a timer passes on only the "
        "last reading, and earlier ones are lost.",
        "Publish inside the callback, at once. Keep the callback short, and give the subscription a depth of 10.",
        about_time=True,
    )


def made_up_first(level: float) -> Verdict:
    """All good readings came, after something that was not said."""
    return see.failed(
        "in-order.made-up-first",
        f"{shown(level)} on {PASSED_ON.name} before the first reading, {shown(GOOD[0])}",
        EXPECTED,
        "The node publishes a value of its own when it starts. A subscriber will think that it was measured.",
        "Publish only inside the callback, and only the reading that it received.",
    )


def in_other_order(ours: tuple[float, ...]) -> Verdict:
    """All good readings came, but not as they were said."""
    place = next(n for n, (one, other) in enumerate(zip(ours, GOOD, strict=False)) if one != other)
    return see.failed(
        "in-order.other-order",
        f"{shown(ours[place])} came where {shown(GOOD[place])} should be, as reading {place + 1}",
        EXPECTED,
        "Readings are collected and sent in another order, such as the newest first or sorted.",
        "Publish each one inside the callback, at once: it is called in the right order.",
    )


def why_others_came(answered: Answered) -> Verdict:
    """Why what came is not what was sent: changed on the way, twice, or in another order."""
    ours = answered.ours
    strange = [level for level in ours if level not in GOOD]
    twice = [level for level in dict.fromkeys(ours) if ours.count(level) > GOOD.count(level) > 0]
    if set(ours) == {0.0}:
        return see.failed(
            "in-order.all-zero",
            f"0 in each of the {len(ours)} messages on {PASSED_ON.name}",
            EXPECTED,
            "The message is never filled, or its data is not a Python float. This build sends an int as 0.0, and "
            "reports no error.",
            "Pass on message.data as it is: Float32(data=message.data), or publish the message itself.",
        )
    if len(ours) > len(GOOD) and ours[-len(GOOD) :] == GOOD:
        return made_up_first(ours[0])
    if strange:
        near = min(GOOD, key=lambda level: abs(level - strange[0]))
        return see.failed(
            "in-order.changed",
            f"{shown(strange[0])} on {PASSED_ON.name}, which was never sent; {shown(near)} was sent",
            EXPECTED,
            "The reading is changed before it is published: rounded, averaged, limited or computed from others.",
            "Pass on message.data as it is.",
        )
    if twice:
        return see.failed(
            "in-order.repeated",
            f"{shown(twice[0])} came {ours.count(twice[0])} times on {PASSED_ON.name}",
            EXPECTED,
            "The callback publishes it twice, two subscriptions receive the same topic, or a timer sends the last "
            "reading again.",
            "Make one subscription, and publish once in each call of the callback.",
        )
    return in_other_order(ours)


INFINITE_IS_BAD = "inf is larger than every number, so it is above 100. And -inf is below 0."
ASK_WHAT_IS_GOOD = "Ask for what is good: 0.0 <= message.data <= 100.0."


def why_bad_ones_came(came: tuple[float, ...]) -> Verdict:
    """Why bad readings were passed on."""
    saw = f"{shown(came[0])} on {PASSED_ON.name}"
    kinds = kinds_of(came)
    if kinds == {"nan"}:
        return see.failed(
            "bad-kept-back.passed-on",
            saw,
            NO_BAD_ONES,
            "nan is not a number: nan < 0 is False, nan > 100 is False, and nan == nan is False, too. So it slips "
            "through any test that asks for what is bad.",
            "Ask for what is good: 0.0 <= message.data <= 100.0 is False for nan. Or ask math.isnan(message.data).",
        )
    if set(came) <= NEAR_LIMITS:
        return see.failed(
            "bad-kept-back.tolerance",
            saw,
            NO_BAD_ONES,
            "The limits are a little wider than 0 and 100 %, or the reading is rounded before it is compared.",
            ASK_WHAT_IS_GOOD,
        )
    return some_of_a_kind(saw, came) or see.failed(
        "bad-kept-back.many-passed-on",
        f"{see.listing(list(dict.fromkeys(map(shown, came))))} on {PASSED_ON.name}",
        NO_BAD_ONES,
        "Several kinds of bad readings are treated as good. A bad reading may be below 0, above 100, or not a "
        "number.",
        ASK_WHAT_IS_GOOD,
    )


def some_of_a_kind(saw: str, came: tuple[float, ...]) -> Verdict | None:
    """Why bad readings of one kind, or on one side of the range, were passed on; None if there are others."""
    if kinds_of(came) == {"inf"}:
        return see.failed(
            "bad-kept-back.infinite-passed-on", saw, NO_BAD_ONES, INFINITE_IS_BAD, ASK_WHAT_IS_GOOD
        )
    if set(came) in (BELOW, ABOVE):
        return see.failed(
            "bad-kept-back.one-limit-missing",
            saw,
            NO_BAD_ONES,
            "Only one of the two limits is checked.",
            ASK_WHAT_IS_GOOD,
        )
    if set(came) < BELOW or set(came) < ABOVE:
        return see.failed(
            "bad-kept-back.other-limit",
            saw,
            NO_BAD_ONES,
            "Other readings on this side of the range are kept back. So the limit is not where it should be, or the "
            "node knows only some bad readings.",
            ASK_WHAT_IS_GOOD,
        )
    return None


def kinds_of(readings: Sequence[float]) -> set[str]:
    """Which kinds of bad readings these are."""
    return {
        "nan" if math.isnan(one) else "inf" if math.isinf(one) else "below" if one < 0.0 else "above"
        for one in readings
    }


# --- why alarms are missing, or too many --------------------------------------------------------------------

ONE_EACH = f"exactly one text on {ALARM.name} for each of the {len(BAD)} bad readings, with its value in it"
VALUE_AS_IT_CAME = (
    'Put the value into the text, as it came: String(data=f"bad battery reading: {message.data}").'
)


def why_no_alarm_came(recording: Recording) -> Verdict:
    """Why no alarm came at all."""
    nothing = f"no alarm arrived on {ALARM.name}"
    if made_late(recording, ALARM):
        return first_alarms_lost(nothing)
    ended = ended_with_an_error(recording, nothing, ONE_EACH)
    if ended is not None:
        return ended
    if not see.values(recording, PASSED_ON):
        return perhaps_not_called(nothing)
    return see.failed(
        "one-alarm.none",
        f"{nothing}, and {len(BAD)} bad readings were sent",
        ONE_EACH,
        "The callback never publishes it.",
        "Publish a String in the callback when the reading is not good.",
        about_time=True,
    )


def first_alarms_lost(saw: str) -> Verdict:
    """Nobody had found the publisher of the alarm by then."""
    return see.failed("one-alarm.publisher-made-late", saw, ONE_EACH, *MADE_LATE)


def perhaps_not_called(saw: str) -> Verdict:
    """Good readings are missing as well as alarms."""
    return see.failed(
        "one-alarm.readings-missing-too",
        saw,
        ONE_EACH,
        "Good readings are missing, too. Perhaps your callback never received the bad one.",
        "First make sure that all good readings are passed on.",
        about_time=True,
    )


def why_not_named(misnamed: Sequence[tuple[int, str]]) -> Verdict:
    """Why there is one alarm for each bad reading, and not each one names its value: half of the points."""
    finite = [(BAD[place], text) for place, text in misnamed if math.isfinite(BAD[place])]
    unnamed = [(reading, text) for reading, text in finite if not names(text, reading)]
    finite = unnamed if 2 * len(unnamed) >= len(finite) else finite  # by chance, a text may name its reading
    reading, text = finite[0] if finite else (BAD[misnamed[0][0]], misnamed[0][1])
    saw = f"the alarm for the bad reading {shown(reading)} says {quoted(text)}"

    def partly(cause: str, because: str, try_this: str = VALUE_AS_IT_CAME) -> Verdict:
        return see.partial(cause, 0.5, saw, ONE_EACH, because, try_this)

    if finite and all(names(told, -one) for one, told in finite):
        return partly("one-alarm.sign-lost", "The sign of the value is missing or wrong.")
    if finite and all(names_as_share(told, one) for one, told in finite):
        return partly("one-alarm.value-divided", "The value is divided by 100. The readings are in percent.")
    if finite and all(names_as_whole(told, one) for one, told in finite):
        return partly(
            "one-alarm.value-rounded",
            "The value is rounded to a whole number, so a reading just outside of the range looks good.",
        )
    if finite and all(names_one_of(READINGS, told) and not names(told, one) for one, told in finite):
        return partly(
            "one-alarm.names-another-reading",
            "The value in this text is that of another reading: of an earlier one, or the same one in each text.",
        )
    return partly(
        "one-alarm.value-not-named",
        "This text must help a person to find the fault, and the value is the best clue.",
    )


def names_as_share(text: str, reading: float) -> bool:
    """Whether an alarm gives a reading divided by 100."""
    return any(
        abs(number) > 0.0 and abs(100.0 * number - reading) <= 1e-3 * abs(reading)
        for number in numbers_in(text)
    )


def names_as_whole(text: str, reading: float) -> bool:
    """Whether an alarm gives a reading as a whole number, which it is not."""
    return any(number.is_integer() and abs(number - reading) < 1.0 for number in numbers_in(text))


def why_alarms_are_missing(recording: Recording, missed: tuple[int, ...]) -> Verdict:
    """Why no alarm came for these bad readings, by their places among the bad ones."""
    readings = tuple(BAD[place] for place in missed)
    saw = f"no alarm for {len(missed)} of {len(BAD)} bad readings, the first of them is {shown(readings[0])}"
    ended = ended_with_an_error(recording, saw, ONE_EACH)
    if ended is not None:
        return ended
    if made_late(recording, ALARM) and readings == BAD[: len(missed)]:
        return first_alarms_lost(saw)
    if len(set(passed_on(recording).lost)) > len(GOOD) // 2:
        return perhaps_not_called(saw)
    if missed == tuple(range(1, len(BAD))):
        return see.failed(
            "one-alarm.first-only",
            saw,
            ONE_EACH,
            "Only the first bad reading raises an alarm: the node remembers that it has raised one.",
            "Publish an alarm for each bad reading, no matter what came before it.",
            about_time=True,
        )
    if set(missed) == BAD_IN_A_ROW:
        return see.failed(
            "one-alarm.one-in-a-row",
            saw,
            ONE_EACH,
            "Of several bad readings in a row, only the first raises an alarm.",
            "Publish an alarm for each bad reading, no matter what came before it.",
            about_time=True,
        )
    return why_no_more_come(recording, saw, missed) or why_a_kind_is_missing(saw, missed)


def why_no_more_come(recording: Recording, saw: str, missed: tuple[int, ...]) -> Verdict | None:
    """Why there are alarms for such readings at first only, or now and then; None if they are of kinds of their own."""
    came = {repr(one) for n, one in enumerate(BAD) if n not in missed}
    if missed == tuple(range(missed[0], len(BAD))) and recording.process.ended_by == "itself":
        return see.failed(
            "one-alarm.ended",
            f"{saw}. Your program had already ended",
            ONE_EACH,
            "The program ends by itself after a while.",
            "Spin until the program is stopped: rclpy.spin(node).",
            about_time=True,
        )
    if set(missed) == SAID_BEFORE:
        return see.failed(
            "one-alarm.equal-once",
            saw,
            ONE_EACH,
            "Each of them is equal to an earlier bad reading, for which an alarm came.",
            "Publish an alarm for each bad reading, no matter what came before it.",
            about_time=True,
        )
    if not came & {repr(BAD[place]) for place in missed}:
        return None
    return see.failed(
        "one-alarm.not-each",
        saw,
        ONE_EACH,
        "For an equal reading an alarm did come. So it depends on more than the reading: on a counter, or on what "
        "came before. Or several readings share an alarm.",
        "Publish an alarm for each bad reading, no matter what came before it.",
        about_time=True,
    )


def why_a_kind_is_missing(saw: str, missed: tuple[int, ...]) -> Verdict:
    """Why no alarm came for bad readings of one kind, or of several."""
    readings = tuple(BAD[place] for place in missed)
    kinds = kinds_of(readings)
    if set(readings) <= NEAR_LIMITS:
        return see.failed(
            "one-alarm.tolerance",
            saw,
            ONE_EACH,
            "Only readings very near to 0 or 100 raise no alarm. The limits are a little wider, or the reading is "
            "rounded before it is compared.",
            ASK_WHAT_IS_GOOD,
            about_time=True,
        )
    if kinds == {"nan"}:
        return see.failed(
            "one-alarm.missed",
            saw,
            ONE_EACH,
            "nan is not a number, and every comparison with it is False: nan < 0, nan > 100, and even nan == nan.",
            "Ask whether the reading is good, 0.0 <= message.data <= 100.0, and raise the alarm if it is not.",
        )
    if kinds == {"inf"}:
        return see.failed(
            "one-alarm.infinite-missed",
            saw,
            ONE_EACH,
            INFINITE_IS_BAD,
            "Ask whether the reading is good, 0.0 <= message.data <= 100.0, and raise the alarm if it is not.",
        )
    return see.failed(
        "one-alarm.kinds-missed",
        saw,
        ONE_EACH,
        "Not every kind of bad reading raises an alarm. A bad reading may be below 0, above 100, or not a number.",
        "Ask whether the reading is good, 0.0 <= message.data <= 100.0, and raise the alarm if it is not.",
        about_time=True,
    )


DECIDE_BY_THIS_ONE = "Decide by this one reading: 0.0 <= message.data <= 100.0."
NO_FALSE_ONES = f"no alarm for the {len(GOOD)} good readings"


def names_an_earlier_one(saw: str) -> Verdict:
    """The alarm came with a good reading, and is about a bad one."""
    return see.failed(
        "no-false-alarm.names-an-earlier-one",
        saw,
        NO_FALSE_ONES,
        "It came with a good reading and names a bad one from before. Any text on this topic is an alarm.",
        "Publish on this topic only when this one reading is bad.",
    )


def names_a_number(text: str) -> bool:
    return bool(numbers_in(text)) or names_one_of(BAD, text)


def names_no_reading(saw: str) -> Verdict:
    """The alarms came with good readings, and name none."""
    return see.failed(
        "no-false-alarm.names-no-reading",
        saw,
        NO_FALSE_ONES,
        "This text came with a good reading, and it names none. Any text on this topic is an alarm, even one that "
        "says that all is well.",
        "Publish on this topic only when this one reading is bad.",
    )


def many_false_alarms(saw: str, *, before_bad: bool) -> Verdict:
    """Why there were alarms for most of the good readings. `before_bad`: even before the first bad one."""
    if before_bad:
        return see.failed(
            "no-false-alarm.every-reading",
            saw,
            NO_FALSE_ONES,
            "Good readings cause texts on this topic, too, even before the first bad one.",
            "Publish on this topic only when a reading is bad.",
        )
    return see.failed(
        "no-false-alarm.goes-on",
        saw,
        NO_FALSE_ONES,
        "After the first alarm, an alarm is raised for every later reading, too.",
        DECIDE_BY_THIS_ONE,
    )


def why_false_alarms(found: Alarms) -> Verdict:
    """Why there were alarms for good readings."""
    false = found.false
    saw = f"{len(false)} alarm{'s' if len(false) > 1 else ''} too many, the first is {quoted(false[0])}"
    expected = NO_FALSE_ONES
    about_bad = [text for text in false if names_one_of(BAD, text) and not names_one_of(INSIDE, text)]
    if len(about_bad) == len(false) and not all(names_one_of(GOOD, text) for text in false):
        return names_an_earlier_one(saw)
    if any(shown(GOOD[place]) in false[0] for place in LOW if GOOD[place]):
        return see.failed(
            "no-false-alarm.low-charge",
            saw,
            expected,
            "A low battery is bad news, but it is not a bad reading.",
            DECIDE_BY_THIS_ONE,
        )
    if len(false) <= len(GOOD) // 2 and not any(names_a_number(text) for text in false):
        return names_no_reading(saw)
    if len(false) > len(GOOD) // 2:
        return many_false_alarms(saw, before_bad=found.before_bad)
    return see.failed(
        "no-false-alarm.good-reading",
        saw,
        expected,
        "Readings from 0 to 100 % are good, both limits included, no matter what came before them.",
        DECIDE_BY_THIS_ONE,
    )


# --- what may explain both ----------------------------------------------------------------------------------

MADE_LATE = (
    "The publisher is created in the callback. Subscriptions need a moment to find it, and what was published "
    "before that is lost.",
    "Create publishers once, in __init__. In the callback, only use them.",
)


def made_late(recording: Recording, one: Topic) -> bool:
    """Whether the publisher was made only when readings were coming in already."""
    seen = recording.topic(one.name).publishers
    first_said = min((word.t for word in recording.said), default=0.0)
    return bool(seen) and all(publisher.first_seen > first_said for publisher in seen)


def ended_with_an_error(recording: Recording, saw: str, expected: str) -> Verdict | None:
    """A failed verdict that blames the error which ended the program; None if it lived on."""
    error = see.last_error(recording)
    if recording.process.ended_by != "itself" or error is None:
        return None
    return see.failed(
        error.cause,
        f"{saw}. Your program had already ended: {error.where}{error.error}",
        expected,
        error.because,
        error.try_this,
    )
