"""How exercise 04 is judged: good and bad readings are said to the monitor, and its answers are compared.

The readings are drawn for each run. What they have in common in each draw is what the causes below tell apart.
"""

import math
import re
from bisect import bisect
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher
from functools import cached_property, lru_cache
from itertools import pairwise
from random import Random

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import Recording, Topic, Verdict, criterion, program_runs, topic, watching

BATTERY_TOPIC, OTHER_TOPIC = "/robot/battery", "/other_robot/battery"
PASSED_ON = topic("/monitor/battery", Float32)
ALARM = topic("/monitor/alarm", String)

AT_ONCE_S = 0.5  # the task names it
SHARE_AT_ONCE = 0.9  # of the readings: the others may have been kept waiting by a busy machine

EXAMPLE = -3.0  # the task names it
BIT = 2.0**-13  # near 100, the smallest difference that 32 bits hold is a sixteenth of it
LIMITS = {0.0, 100.0}
LOW_AT_MOST = 20.0
NEAR_LIMIT = 0.5
JUMP = 10.0
APART_S, MOMENT_S, SAME_MOMENT_S = 0.1, 0.05, 0.01
PAUSE_S, OTHERS_AFTER_S = 1.0, 0.55
EARLIEST_S, LATEST_S, LONGER_GAPS = 0.3, 0.7, 6

# Which good reading is what, counted from 1. A battery drains, is changed for a full one, runs out, and is changed
# again.
FULL_ONE, FIRST_LOW, EMPTY_ONE, FIRST_AGAIN, LAST_GOOD = 9, 19, 22, 23, 42
AT_ONE_MOMENT = 4
BAD_ONES = 12


def is_good(reading: float) -> bool:
    return 0.0 <= reading <= 100.0


def draining(rng: Random, first: float, count: int, most: float) -> list[float]:
    """Readings that get lower by a quarter up to `most`, all of them whole quarters."""
    levels = [first]
    while len(levels) < count:
        levels.append(levels[-1] - rng.randint(1, round(4 * most)) / 4)
    return levels


def drawn_good_ones(rng: Random, equals: Sequence[int]) -> list[float]:
    """All good readings, in order. Only those at `equals`, counted from 1, are equal to others: to the next ones."""
    lows = [rng.randint(40, 79) / 4, rng.randint(8, 36) / 4, rng.randint(3, 7) / 8, 0.0]
    good = [
        *draining(rng, rng.randint(176, 216) / 4, FULL_ONE - 1, 1.0),
        *draining(rng, 100.0, FIRST_LOW - FULL_ONE, 1.5),
        *lows,
        *draining(rng, rng.randint(304, 340) / 4, LAST_GOOD - EMPTY_ONE, 0.75),
    ]
    for place in equals:
        good[place] = good[place - 1]
    return good


def drawn_bad_ones(rng: Random) -> list[list[float]]:
    """Bad readings, those in a row together.

    Only a first one in a row is said once more later: else an alarm could be about either.
    """
    above = rng.randint(420, 780) / 4
    not_finite = [math.inf, math.nan]
    rng.shuffle(not_finite)
    rows = [
        [EXAMPLE, EXAMPLE],
        [math.nan],
        [above, *not_finite],
        [rng.choice((-0.125, -0.25))],
        [100.0 + BIT],
        [rng.randint(1, 8) * 1e9],
        [-BIT],
        [-math.inf],
    ]
    rng.shuffle(rows)
    return [*rows, [above]]


def fits(rows: Sequence[Sequence[float]], slots: Sequence[int]) -> bool:
    """Whether these bad readings may come behind these good ones.

    Of what is not finite, nan comes first, after an alarm: who cannot bear it ends there. Two good readings lie
    between bad ones, so that it shows what came in place of which. And a bad reading lies between each limit and the
    one that is hardly beyond it, because a rounded alarm may name either.
    """
    begins = [row[0] for row in rows if not all(map(math.isfinite, row))]
    near = [
        place - bisect(slots, limit - 1)
        for limit, beyond in ((FULL_ONE, 100.0 + BIT), (EMPTY_ONE, -BIT))
        for place in (rows.index([beyond]),)
    ]
    return (
        math.isnan(begins[0])
        and not math.isnan(rows[0][0])
        and all(later - slot > 1 for slot, later in pairwise(slots))
        and not {-1, 0} & {*near}
    )


def drawn_readings(rng: Random) -> list[tuple[float, float]]:
    """Each reading with the moment (s of simulated time) at which it is said."""
    pause = rng.randint(3, 6)
    at_one_moment = rng.randint(FIRST_AGAIN + 3, LAST_GOOD - 8)
    moment = range(at_one_moment, at_one_moment + AT_ONE_MOMENT)
    later = [n for n in range(FIRST_AGAIN + 1, LAST_GOOD - 2) if not {n, n + 1} & {*moment}]
    equals = [rng.randint(2, 6), rng.choice(later)]
    # Behind these no bad ones come: one in front of a limit may be clamped to it, and one beside equal ones repeated.
    taken = {pause, FULL_ONE - 1, EMPTY_ONE - 1, moment[0] - 1, *moment}
    taken |= {behind for n in equals for behind in (n - 1, n)}
    early, free = ([n for n in some if n not in taken] for some in (range(3, 8), range(3, LAST_GOOD)))
    while True:
        rows = drawn_bad_ones(rng)
        first = rng.choice(early)
        others = sorted(rng.sample([n for n in free if n > first], len(rows) - 2))
        slots = [first, *others, LAST_GOOD]
        if fits(rows, slots):
            break
    longer = rng.sample([n for n in range(1, LAST_GOOD) if n != pause and n not in moment], LONGER_GAPS)
    lines, at = [], rng.randint(round(10 * EARLIEST_S), round(10 * LATEST_S)) / 10
    for number, reading in enumerate(drawn_good_ones(rng, equals), 1):
        # On simulated time, all that is due within one step of 0.1 s is said together.
        before_s = SAME_MOMENT_S * (moment[-1] - number) if number in moment else 0.0
        lines.append((at - before_s, reading))
        at += 0.0 if number in moment[:-1] else APART_S
        at += APART_S if number in longer or number + 1 == moment[0] else PAUSE_S if number == pause else 0.0
        for bad in rows[slots.index(number)] if number in slots else ():
            lines.append((at, bad))
            at += APART_S
    return lines


def drawn(rng: Random) -> list[see.Part]:
    """The readings of both robots. Those of the other one are no whole quarters: ours, or what is made of them, are."""
    lines = drawn_readings(rng)
    begin = next(at for (at, _), (later, _) in pairwise(lines) if later - at > PAUSE_S)
    others = [
        rng.choice((1, -3, 5)) / 8 + level
        for level in (rng.randint(60, 80), rng.randint(-50, -30), rng.randint(60, 80))
    ]
    times = (begin + OTHERS_AFTER_S, begin + OTHERS_AFTER_S + 0.1, lines[-1][0] + 0.4)
    return [
        see.publish(BATTERY_TOPIC, Float32, lines),
        see.publish(OTHER_TOPIC, Float32, [*zip(times, others, strict=True)], awaited=False),
    ]


# A timer that repeats the last alarm each second does so in the time after the last reading.
GAPS = LAST_GOOD + BAD_ONES - AT_ONE_MOMENT + 1 + LONGER_GAPS
WATCH_S = LATEST_S + APART_S * GAPS + PAUSE_S + 1.4

WATCH = watching(simulated_seconds=WATCH_S, wall_seconds=WATCH_S, script=drawn)


@dataclass(frozen=True)
class Readings:
    """The readings of one run, and what some of them have in common, by their places among the good or bad ones."""

    readings: tuple[float, ...]
    said_at: tuple[float, ...]
    others: tuple[float, ...]

    @cached_property
    def good_places(self) -> tuple[int, ...]:
        return tuple(place for place, reading in enumerate(self.readings) if is_good(reading))

    @cached_property
    def bad_places(self) -> tuple[int, ...]:
        return tuple(place for place, reading in enumerate(self.readings) if not is_good(reading))

    @cached_property
    def good(self) -> tuple[float, ...]:
        return tuple(self.readings[place] for place in self.good_places)

    @cached_property
    def bad(self) -> tuple[float, ...]:
        return tuple(self.readings[place] for place in self.bad_places)

    @property
    def below(self) -> set[float]:
        return {one for one in self.bad if one < 0.0}

    @property
    def above(self) -> set[float]:
        return {one for one in self.bad if one > 100.0}

    @property
    def near_limits(self) -> set[float]:
        return {one for one in self.bad if -NEAR_LIMIT < one < 100.0 + NEAR_LIMIT}

    @property
    def inside(self) -> tuple[float, ...]:
        return tuple(reading for reading in self.good if reading not in LIMITS)

    @property
    def after_bad(self) -> set[int]:
        """Good ones."""
        return {n for n, place in enumerate(self.good_places) if place - 1 in self.bad_places}

    @property
    def equal_to_last(self) -> set[int]:
        return {n for n, (last, one) in enumerate(pairwise(self.good), 1) if last == one}

    @property
    def jumps(self) -> set[int]:
        return {n for n, (last, one) in enumerate(pairwise(self.good), 1) if abs(last - one) > JUMP}

    @property
    def in_a_moment(self) -> set[int]:
        """Good ones that were said together with others."""
        soon = {n for n, (last, one) in enumerate(pairwise(self.said_at), 1) if one - last < MOMENT_S}
        return {n for n, place in enumerate(self.good_places) if {place, place + 1} & soon}

    @property
    def low(self) -> set[int]:
        return {n for n, reading in enumerate(self.good) if reading <= LOW_AT_MOST}

    @property
    def risen(self) -> set[int]:
        return {n for n, reading in enumerate(self.good) if n and reading > min(self.good[:n])}

    @property
    def said_before(self) -> set[int]:
        """Bad ones that are equal to one before."""
        return {n for n, one in enumerate(self.bad) if repr(one) in map(repr, self.bad[:n])}

    @property
    def bad_in_a_row(self) -> set[int]:
        """Bad ones that follow directly after another."""
        return {n for n, (last, one) in enumerate(pairwise(self.bad_places), 1) if one == last + 1}


def said_readings(recording: Recording) -> Readings:
    """What was said to the monitor, or still was to be said when it ended."""
    words = see.script(recording, BATTERY_TOPIC)
    others = see.script(recording, OTHER_TOPIC)
    return Readings(
        tuple(word.value["data"] for word in words),
        tuple(word.t for word in words),
        tuple(word.value["data"] for word in others),
    )


LONGEST_QUOTE = 60  # characters of an alarm that feedback quotes


@criterion(points=1, title="It subscribes to /robot/battery, type Float32", needs=[program_runs])
def listens(recording: Recording) -> Verdict:
    return see.listens(recording, topic(BATTERY_TOPIC, Float32))


@criterion(points=1, title="/monitor/battery carries Float32", needs=[program_runs])
def battery_topic(recording: Recording) -> Verdict:
    verdict = see.publishes(recording, PASSED_ON)
    if not verdict.ok and recording.topic(BATTERY_TOPIC).publishers:
        return see.failed(
            "battery-topic.publishes-where-it-listens",
            f"your node publishes {BATTERY_TOPIC}, but nothing on {PASSED_ON.name}",
            verdict.expected,
            "It publishes to the topic that it subscribes to. So every message that it publishes triggers another "
            "one, endlessly.",
            f"Write the name as {PASSED_ON.name!r}.",
        )
    return verdict


@criterion(points=0, title="It forwards readings", needs=[listens, battery_topic])
def passes_on(recording: Recording) -> Verdict:
    if see.values(recording, PASSED_ON):
        return see.passed("readings come")
    return why_nothing_came(recording)


@criterion(
    points=2, title="All good readings are forwarded, right away, in the right order", needs=[passes_on]
)
def in_order(recording: Recording) -> Verdict:
    answered, said = passed_on(recording), said_readings(recording)
    if answered.ours == said.good:
        return at_once(recording)
    if answered.extra:
        return why_others_came(answered, said)
    return why_some_are_missing(recording, answered.lost)


@criterion(
    points=1, title="No bad reading is forwarded, and nothing is sent instead of it", needs=[passes_on]
)
def bad_kept_back(recording: Recording) -> Verdict:
    said = said_readings(recording)
    answered = passed_on(recording)
    if answered.instead and set(answered.instead) <= LIMITS:
        return see.failed(
            "bad-kept-back.clamped",
            f"{shown(answered.instead[0])} on {PASSED_ON.name} instead of a bad reading",
            NO_BAD_ONES,
            "Your node replaces a bad reading with the nearest limit. But a subscriber will assume that this value "
            "was measured.",
            "Raise the alarm, and don't publish anything on this topic.",
        )
    if answered.instead:
        return see.failed(
            "bad-kept-back.replaced",
            f"{shown(answered.instead[0])} on {PASSED_ON.name} instead of a bad reading",
            NO_BAD_ONES,
            "Your node makes up a reading. But a subscriber will assume that it was measured.",
            "Raise the alarm, and don't publish anything on this topic.",
        )
    if len(answered.bad) > sum(map(math.isnan, said.bad)) and all(map(math.isnan, answered.bad)):
        return see.failed(
            "bad-kept-back.nan-instead",
            f"nan {len(answered.bad)} times on {PASSED_ON.name}, more often than it was sent",
            NO_BAD_ONES,
            "Your node publishes nan instead of other bad readings. A subscriber that compares it with a limit is "
            "misled, because every comparison with nan is False.",
            "Raise the alarm, and don't publish anything on this topic.",
        )
    if answered.bad:
        return why_bad_ones_came(answered.bad, said)
    return see.passed("no bad reading was forwarded, and nothing was sent instead of it")


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
    said = said_readings(recording)
    found = alarms(recording)
    if found.misnamed:
        return why_not_named(found.misnamed, said)
    if len(found.repeated) > len(found.missed):
        return see.failed(
            "one-alarm.repeated",
            f"{see.count(len(found.repeated), 'extra alarm')} for bad readings, the first "
            f"{quoted(found.repeated[0])}",
            ONE_EACH,
            "Your node publishes the alarm in a timer or a loop, more than once in the callback, or from more than "
            "one subscription.",
            "Publish it inside the callback, once for each bad reading.",
        )
    if found.missed:
        return why_alarms_are_missing(recording, found.missed)
    return see.passed(f"{len(said.bad)} alarms for {len(said.bad)} bad readings")


@criterion(points=1, title="No alarm for good readings", needs=[alarms_come])
def no_false_alarm(recording: Recording) -> Verdict:
    found = alarms(recording)
    return why_false_alarms(found, said_readings(recording)) if found.false else see.passed("none")


@criterion(points=1, title="It ignores /other_robot/battery", needs=[passes_on])
def own_robot_only(recording: Recording) -> Verdict:
    others, about_them = passed_on(recording).others, alarms(recording).others
    if not others and not about_them:
        return see.passed(
            f"{len(said_readings(recording).others)} readings of another robot, none of them forwarded or reported"
        )
    saw = f"{shown(others[0])} on {PASSED_ON.name}" if others else f"the alarm {quoted(about_them[0])}"
    return see.failed(
        "own-robot-only.hears-others",
        f"{saw}, which is a reading from {OTHER_TOPIC}",
        f"only readings from {BATTERY_TOPIC}",
        "The node subscribes to more than its own robot's battery.",
        f"Create only one subscription, to {BATTERY_TOPIC!r}.",
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
    said = said_readings(recording)
    levels = [level for level in see.values(recording, PASSED_ON) if isinstance(level, float)]
    others = tuple(level for level in levels if level in said.others)
    bad = tuple(level for level in levels if not is_good(level) and level not in said.others)
    good = [level for level in levels if is_good(level) and level not in said.others]
    lost: list[int] = []
    extra: list[float] = []
    instead: list[float] = []
    ours: list[float] = []
    for kind, i, end, j, to in SequenceMatcher(None, said.good, good, autojunk=False).get_opcodes():
        came = good[j:to]
        if kind == "insert" and len(came) <= bad_before(behind_equals(i, came, said), said):
            instead += came
            continue
        ours += came
        if kind != "equal":
            lost += range(i, end)
            extra += came
    if instead and extra:  # more than the bad readings brings something that was not sent
        return Answered(tuple(good), tuple(lost), (*instead, *extra), (), bad, others)
    return Answered(tuple(ours), tuple(lost), tuple(extra), tuple(instead), bad, others)


def behind_equals(place: int, came: list[float], said: Readings) -> int:
    """Where what came may stand as well: behind good readings that it is equal to."""
    while place < len(said.good) and {said.good[place]} == set(came):
        place += 1
    return place


def bad_before(place: int, said: Readings) -> int:
    """How many bad readings were said between the good one at `place` and the one before."""
    last = said.good_places[place - 1] if place else -1
    here = said.good_places[place] if place < len(said.good) else len(said.readings)
    return here - last - 1


def at_once(recording: Recording) -> Verdict:
    """All good readings came in order; whether they came at once."""
    said = said_readings(recording)
    said_at = [word.t for word in see.published(recording, BATTERY_TOPIC) if is_good(word.value["data"])]
    came_at = moments_of_good_ones(recording)
    late = late_ones(recording)
    if len(came_at) != len(said_at) or len(late) <= (1.0 - SHARE_AT_ONCE) * len(said_at):
        return see.passed(f"{len(said.good)} good readings, right away and in order")
    return see.failed(
        "in-order.late",
        f"{len(late)} of {len(said.good)} good readings arrived late, one of them after {max(late):.1f} s",
        f"each good reading on {PASSED_ON.name} within {AT_ONCE_S} s",
        "Your node collects readings and publishes them later, from a timer or in groups. Or the callback sleeps.",
        "Publish each reading right away, inside the callback.",
        about_time=True,
    )


def moments_of_good_ones(recording: Recording) -> list[float]:
    """When good readings arrived on /monitor/battery (s)."""
    said = said_readings(recording)
    return [
        arrival.t
        for arrival in recording.topic(PASSED_ON.name).arrivals
        if arrival.value["data"] in said.good and arrival.value["data"] not in said.others
    ]


def late_ones(recording: Recording) -> list[float]:
    """How late (s) those good readings came that came late, if none is missing before the last one that came."""
    said_at = [word.t for word in see.published(recording, BATTERY_TOPIC) if is_good(word.value["data"])]
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
    said = said_readings(recording)
    sent = [(str(one.value.get("data")), one.published) for one in recording.topic(ALARM.name).arrivals]
    of_others = [is_about_others(recording, said, *one) for one in sent]
    others = [text for (text, _), about in zip(sent, of_others, strict=True) if about]
    own = [one for one, about in zip(sent, of_others, strict=True) if not about]
    pairs = told_apart([text for text, _ in own], said.bad)
    missed = tuple(sorted(set(range(len(said.bad))) - pairs.keys()))
    named = set(pairs.values())
    rest = [one for n, one in enumerate(own) if n not in named]
    after_bad = [one for one in rest if not is_good(last_reading(recording, one[1]))]
    if missed and len(own) == len(said.bad) and 2 * len(after_bad) > len(rest):
        misnamed = tuple(
            (place, own[place][0]) for place in range(len(said.bad)) if pairs.get(place) != place
        )
        return Alarms((), misnamed, (), (), tuple(others))
    due = {own[n][0] for n in pairs.values()}
    false = [one for one in rest if is_false(recording, said, *one, due)]
    set_of_false = set(false)
    first_bad = min(
        (word.wall for word in see.published(recording, BATTERY_TOPIC) if not is_good(word.value["data"])),
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


def told_apart(texts: Sequence[str], bad: Sequence[float]) -> dict[int, int]:
    """As `in_turn`, without the texts that are the same for different readings: they name no reading."""
    pairs = in_turn(texts, bad)
    about: dict[str, set[str]] = {}
    for reading, text in pairs.items():
        about.setdefault(texts[text], set()).add(repr(bad[reading]))
    return {reading: text for reading, text in pairs.items() if len(about[texts[text]]) == 1}


def in_turn(texts: Sequence[str], bad: Sequence[float]) -> dict[int, int]:
    """For as many bad readings as possible, in their order, a text that names it: place of the reading, of the text."""
    named = [[names(text, reading) for reading in bad] for text in texts]
    longest = [[0] * (len(texts) + 1) for _ in range(len(bad) + 1)]
    for i in reversed(range(len(bad))):
        for j in reversed(range(len(texts))):
            both = longest[i + 1][j + 1] + 1 if named[j][i] else 0
            longest[i][j] = max(both, longest[i + 1][j], longest[i][j + 1])
    pairs, i, j = {}, 0, 0
    while i < len(bad) and j < len(texts):
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


def is_about_others(recording: Recording, said: Readings, text: str, published: float) -> bool:
    """Whether an alarm is about the other robot. `published`: its wall time (s)."""
    if set(numbers_in(text)) & set(said.others):
        return True
    if names_one_of(said.bad, text):
        return False
    last = see.latest_before(((one.wall, one) for one in recording.published), published)
    return last is not None and last.topic == OTHER_TOPIC


def last_reading(recording: Recording, published: float) -> float:
    """The reading that was said last before an alarm was published; 0 before the first one."""
    last = see.latest_before(((one.wall, one) for one in see.published(recording, BATTERY_TOPIC)), published)
    return 0.0 if last is None else float(last.value["data"])


def is_false(recording: Recording, said: Readings, text: str, published: float, due: Collection[str]) -> bool:
    """Whether an alarm is about a good reading. `due`: the texts that are one alarm for each bad reading."""
    last = last_reading(recording, published)
    if names_one_of(said.bad, text):
        return is_good(last) and (text not in due or names(text, last))
    # 0 and 100 are no proof: an alarm may name the limits.
    if set(numbers_in(text)) & (set(said.good) - LIMITS):
        return True
    return is_good(last)


def shown(level: float) -> str:
    return f"{level:.7g}"


def quoted(alarm: str) -> str:
    return f'"{alarm[:LONGEST_QUOTE]}"'


# --- why readings do not come as they were sent -------------------------------------------------------------

EXPECTED = f"each good reading on {PASSED_ON.name}, once, in the order of arrival"
NO_BAD_ONES = f"nothing on {PASSED_ON.name} for a bad reading"


def why_nothing_came(recording: Recording) -> Verdict:
    """Why nothing arrived on /monitor/battery."""
    said = said_readings(recording)
    nothing = f"nothing on {PASSED_ON.name}"
    asked = {one.durability for one in recording.topic(BATTERY_TOPIC).subscribers}
    if asked == {"transient_local"}:
        return see.failed(
            "in-order.asks-for-old-messages",
            f"{nothing}: your subscription requests transient local",
            EXPECTED,
            "Your subscription requests messages from before it existed, but the sensor's publisher keeps none. So "
            "the two never match.",
            "Give create_subscription() a plain depth, such as 10.",
        )
    if made_late(recording, PASSED_ON):
        return see.failed("in-order.publisher-made-late", nothing, EXPECTED, *MADE_LATE)
    return see.program_ended(recording, nothing, EXPECTED) or see.failed(
        "in-order.nothing-passed-on",
        f"{len(said.readings)} readings were published on {BATTERY_TOPIC}, but nothing arrived on {PASSED_ON.name}",
        EXPECTED,
        "Either nothing spins the node, so the callback never runs, or the callback doesn't publish.",
        "Spin the node with rclpy.spin(node), and publish the good readings inside the callback.",
        about_time=True,
    )


def why_some_are_missing(recording: Recording, lost: tuple[int, ...]) -> Verdict:
    """Why these good readings, by their places, did not come."""
    said = said_readings(recording)
    came = len(said.good) - len(lost)
    saw = (
        f"{came} of {len(said.good)} good readings arrived; the first missing one is "
        f"{shown(said.good[lost[0]])} %"
    )
    return (
        ended_with_an_error(recording, saw, EXPECTED)
        or kept_back_for_its_value(said, saw, set(lost))
        or kept_back_for_what_came_before(recording, saw, set(lost))
        or lost_on_the_way(recording, saw, lost)
    )


def kept_back_for_its_value(said: Readings, saw: str, lost: set[int]) -> Verdict | None:
    """Why the monitor did not want readings of such values; None if they have none in common."""
    if {said.good[place] for place in lost} <= LIMITS:
        return see.failed(
            "in-order.limits-kept-back",
            saw,
            EXPECTED,
            "0 and 100 % are good readings, too: an empty battery and a full one. The range includes both limits.",
            "Use <= where you have <: 0.0 <= message.data <= 100.0.",
            about_time=True,
        )
    if lost <= said.low:
        return see.failed(
            "in-order.low-kept-back",
            saw,
            EXPECTED,
            "Only low charges are missing. A low charge is bad news, but not a bad reading.",
            "Forward every reading from 0 to 100 %.",
            about_time=True,
        )
    return None


def kept_back_for_what_came_before(recording: Recording, saw: str, lost: set[int]) -> Verdict | None:
    """Why the monitor did not want these readings after those before them; None if nothing says so."""
    said = said_readings(recording)
    came = passed_on(recording).ours
    if came == all_but(said.after_bad, said.good):
        return see.failed(
            "in-order.after-bad-kept-back",
            saw,
            EXPECTED,
            "The missing readings directly followed a bad one. But whether a reading is good depends on that "
            "reading alone.",
            EACH_FOR_ITSELF,
            about_time=True,
        )
    if came == all_but(said.equal_to_last, said.good):
        return see.failed(
            "in-order.equal-kept-back",
            saw,
            EXPECTED,
            "The missing readings are equal to the ones before them. But a charge may stay the same.",
            "Forward each good reading, no matter what the previous one was.",
            about_time=True,
        )
    return (
        jumps_or_stops(said, saw, lost)
        or taken_for_bad(recording, saw, lost)
        or risen_kept_back(said, saw, lost)
    )


def jumps_or_stops(said: Readings, saw: str, lost: set[int]) -> Verdict | None:
    """Whether the monitor kept back what came after a jump, or all after a bad reading."""
    if lost <= said.jumps:
        return see.failed(
            "in-order.jumps-kept-back",
            saw,
            EXPECTED,
            "The missing readings follow a jump. But the charge also jumps when an empty battery is replaced by a "
            "full one.",
            EACH_FOR_ITSELF,
            about_time=True,
        )
    if lost == {*range(min(said.after_bad, default=len(said.good)), len(said.good))}:
        return see.failed(
            "in-order.stops-at-the-bad-one",
            saw,
            EXPECTED,
            "Nothing is forwarded after the first bad reading. The node ends, or it stores the fault, forever or "
            "for a while.",
            "Judge each reading on its own, and return from the callback without an error after the alarm.",
            about_time=True,
        )
    return None


def risen_kept_back(said: Readings, saw: str, lost: set[int]) -> Verdict | None:
    """Whether the monitor kept back all that is higher than a reading before it, from some reading on."""
    since = set(range(min(lost), len(said.good)))
    if lost != said.risen & since or lost == since:
        return None
    return see.failed(
        "in-order.risen-kept-back",
        saw,
        EXPECTED,
        "All missing readings are higher than an earlier one. But the charge rises when an empty battery is "
        "replaced by a full one.",
        EACH_FOR_ITSELF,
        about_time=True,
    )


def taken_for_bad(recording: Recording, saw: str, lost: set[int]) -> Verdict | None:
    """Whether the monitor raised alarms about the readings that are missing."""
    said = said_readings(recording)
    alarmed = alarms(recording).false
    of_them = [
        said.good[place] for place in sorted(lost) if any(names(text, said.good[place]) for text in alarmed)
    ]
    if of_them and 2 * len(of_them) > len(lost):
        return see.failed(
            "in-order.taken-for-bad",
            f"{saw}; there is an alarm for {shown(of_them[0])} %",
            EXPECTED,
            "Your node treats good readings as bad. Perhaps it compares each reading with the previous one.",
            EACH_FOR_ITSELF,
            about_time=True,
        )
    return None


EACH_FOR_ITSELF = "Judge each reading on its own: is it a charge from 0 to 100 %?"


def all_but(places: set[int], good: Sequence[float]) -> tuple[float, ...]:
    """The good readings without those at these places."""
    return tuple(reading for n, reading in enumerate(good) if n not in places)


def lost_on_the_way(recording: Recording, saw: str, lost: tuple[int, ...]) -> Verdict:
    """Why these readings are missing, if not for what they say."""
    said = said_readings(recording)
    if recording.process.ended_by == "itself" and lost == tuple(range(lost[0], len(said.good))):
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
    return (
        lost_at_an_end(said, saw, lost)
        or none_from_one_on(recording, saw, lost)
        or lost_among_others(said, saw, lost)
    )


def none_from_one_on(recording: Recording, saw: str, lost: tuple[int, ...]) -> Verdict | None:
    """Why all came up to one reading, and none from it on; None if it is not so, or if many of them came late."""
    said = said_readings(recording)
    if lost != tuple(range(lost[0], len(said.good))):
        return None
    late = late_ones(recording)
    if len(late) <= (1.0 - SHARE_AT_ONCE) * lost[0]:
        return see.failed(
            "in-order.stops",
            saw,
            EXPECTED,
            "All readings before it arrived right away, but neither this one nor any later one did. Your node "
            "counts readings or alarms, it stores an error, a callback never returns, or nothing spins the node "
            "any more.",
            "Treat every reading the same, let the callback return, and spin until the program is stopped.",
            about_time=True,
        )
    if come_in_groups(recording):
        return see.failed(
            "in-order.in-groups",
            f"{saw}; {len(late)} of the others arrived late, one of them after {max(late):.1f} s",
            EXPECTED,
            "Your node collects readings and publishes them in groups, but the last group was not full.",
            "Publish each reading right away, inside the callback.",
            about_time=True,
        )
    return None


def lost_at_an_end(said: Readings, saw: str, lost: tuple[int, ...]) -> Verdict | None:
    """Why only the first or only the last one is missing; None if it is not so."""
    if lost == (0,):
        return see.failed(
            "in-order.first-one-lost",
            saw,
            EXPECTED,
            "Only the first reading is missing. The node skips it, or uses it for something else.",
            "Forward each good reading, including the first one.",
            about_time=True,
        )
    if lost == (len(said.good) - 1,):
        return see.failed(
            "in-order.held-back",
            saw,
            EXPECTED,
            "Only the last reading is missing. Your node keeps each reading until the next one arrives.",
            "Publish each reading right away, inside the callback.",
            about_time=True,
        )
    return None


def lost_among_others(said: Readings, saw: str, lost: tuple[int, ...]) -> Verdict:
    """Why these are missing, and others came before and after them."""
    if set(lost) <= said.in_a_moment:
        return see.failed(
            "in-order.several-at-once-lost",
            saw,
            EXPECTED,
            "The missing readings arrived at almost the same time as another one. The queue was too short for "
            "them, or your node skips readings that arrive too soon.",
            "Give the subscription a depth of 10, and publish in every call of the callback.",
            about_time=True,
        )
    return see.failed(
        "in-order.some-lost",
        saw,
        EXPECTED,
        "Your node was busy or asleep while they arrived, and the queue was too short. Or a timer forwards only "
        "the latest reading, so earlier ones are lost.",
        "Publish right away, inside the callback. Keep the callback short, and give the subscription a depth of 10.",
        about_time=True,
    )


def made_up_first(level: float, first: float) -> Verdict:
    """All good readings came, after something that was not said."""
    return see.failed(
        "in-order.made-up-first",
        f"{shown(level)} on {PASSED_ON.name} before the first reading, {shown(first)}",
        EXPECTED,
        "Your node publishes a value of its own when it starts. But a subscriber will assume that it was measured.",
        "Publish only inside the callback, and only the reading that it received.",
    )


def in_other_order(ours: tuple[float, ...], good: Sequence[float]) -> Verdict:
    """All good readings came, but not as they were said."""
    place = next(n for n, (one, other) in enumerate(zip(ours, good, strict=False)) if one != other)
    return see.failed(
        "in-order.other-order",
        f"reading {place + 1} was {shown(ours[place])} instead of {shown(good[place])}",
        EXPECTED,
        "Your node collects readings and publishes them in another order, such as newest first or sorted.",
        "Publish each reading right away, inside the callback: rclpy calls it in the right order.",
    )


def why_others_came(answered: Answered, said: Readings) -> Verdict:
    """Why what came is not what was sent: changed on the way, twice, or in another order."""
    ours = answered.ours
    strange = [level for level in ours if level not in said.good]
    twice = [level for level in dict.fromkeys(ours) if ours.count(level) > said.good.count(level) > 0]
    if set(ours) == {0.0}:
        return see.failed(
            "in-order.all-zero",
            f"only 0 on {PASSED_ON.name}, in {see.count(len(ours), 'message')}",
            EXPECTED,
            "The message's data is never set, or it isn't a Python float. This build sends an int as 0.0, without "
            "an error.",
            "Forward message.data unchanged: Float32(data=message.data), or publish the message itself.",
        )
    if len(ours) > len(said.good) and ours[-len(said.good) :] == said.good:
        return made_up_first(ours[0], said.good[0])
    if strange:
        near = min(said.good, key=lambda level: abs(level - strange[0]), default=strange[0])
        return see.failed(
            "in-order.changed",
            f"{shown(strange[0])} on {PASSED_ON.name}, which was never sent; {shown(near)} was sent",
            EXPECTED,
            "The reading is changed before it's published: rounded, averaged, limited, or computed from others.",
            "Forward message.data unchanged.",
        )
    if twice:
        return see.failed(
            "in-order.repeated",
            f"{shown(twice[0])} arrived {ours.count(twice[0])} times on {PASSED_ON.name}",
            EXPECTED,
            "The callback publishes it twice, two subscriptions use the same topic, or a timer repeats the last "
            "reading.",
            "Create one subscription, and publish once in each call of the callback.",
        )
    return in_other_order(ours, said.good)


INFINITE_IS_BAD = "inf is larger than every number, so it's above 100. And -inf is below 0."
ASK_WHAT_IS_GOOD = "Test for good readings: 0.0 <= message.data <= 100.0."


def why_bad_ones_came(came: tuple[float, ...], said: Readings) -> Verdict:
    """Why bad readings were passed on."""
    saw = f"{shown(came[0])} on {PASSED_ON.name}"
    kinds = kinds_of(came)
    if kinds == {"nan"}:
        return see.failed(
            "bad-kept-back.passed-on",
            saw,
            NO_BAD_ONES,
            "nan is not a number: nan < 0 is False, nan > 100 is False, and nan == nan is False, too. So it slips "
            "through any test for bad readings.",
            "Test for good readings: 0.0 <= message.data <= 100.0 is False for nan. Or test "
            "math.isnan(message.data).",
        )
    if set(came) <= said.near_limits:
        return see.failed(
            "bad-kept-back.tolerance",
            saw,
            NO_BAD_ONES,
            "Your limits are a little wider than 0 and 100 %, or the reading is rounded before the comparison.",
            ASK_WHAT_IS_GOOD,
        )
    return some_of_a_kind(saw, came, said) or see.failed(
        "bad-kept-back.many-passed-on",
        f"{see.listing(list(dict.fromkeys(map(shown, came))))} on {PASSED_ON.name}",
        NO_BAD_ONES,
        "Your node treats several kinds of bad readings as good. A bad reading may be below 0, above 100, or not a "
        "number.",
        ASK_WHAT_IS_GOOD,
    )


def some_of_a_kind(saw: str, came: tuple[float, ...], said: Readings) -> Verdict | None:
    """Why bad readings of one kind, or on one side of the range, were passed on; None if there are others."""
    if kinds_of(came) == {"inf"}:
        return see.failed(
            "bad-kept-back.infinite-passed-on", saw, NO_BAD_ONES, INFINITE_IS_BAD, ASK_WHAT_IS_GOOD
        )
    if set(came) in (said.below, said.above):
        return see.failed(
            "bad-kept-back.one-limit-missing",
            saw,
            NO_BAD_ONES,
            "Only one of the two limits is checked.",
            ASK_WHAT_IS_GOOD,
        )
    if set(came) < said.below or set(came) < said.above:
        return see.failed(
            "bad-kept-back.other-limit",
            saw,
            NO_BAD_ONES,
            "Your node holds back other readings on this side of the range. So your limit is in the wrong place, "
            "or the node recognizes only some bad readings.",
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

ONE_EACH = f"exactly one text on {ALARM.name} for each bad reading, with its value in it"
VALUE_AS_IT_CAME = (
    'Put the unchanged value into the text: String(data=f"bad battery reading: {message.data}").'
)


def why_no_alarm_came(recording: Recording) -> Verdict:
    """Why no alarm came at all."""
    said = said_readings(recording)
    nothing = f"no alarm arrived on {ALARM.name}"
    if made_late(recording, ALARM):
        return first_alarms_lost(nothing)
    ended = see.program_ended(recording, nothing, ONE_EACH)
    if ended is not None:
        return ended
    if not see.values(recording, PASSED_ON):
        return perhaps_not_called(nothing)
    return see.failed(
        "one-alarm.none",
        f"{nothing}, although {len(said.bad)} bad readings were sent",
        ONE_EACH,
        "The callback never publishes an alarm.",
        "Publish a String in the callback if the reading isn't good.",
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
        "First, make sure that all good readings are forwarded.",
        about_time=True,
    )


def why_not_named(misnamed: Sequence[tuple[int, str]], said: Readings) -> Verdict:
    """Why there is one alarm for each bad reading, and not each one names its value: half of the points."""
    finite = [(said.bad[place], text) for place, text in misnamed if math.isfinite(said.bad[place])]
    unnamed = [(reading, text) for reading, text in finite if not names(text, reading)]
    finite = unnamed if 2 * len(unnamed) >= len(finite) else finite  # by chance, a text may name its reading
    reading, text = finite[0] if finite else (said.bad[misnamed[0][0]], misnamed[0][1])
    saw = f"the alarm for the bad reading {shown(reading)} is {quoted(text)}"

    def partly(cause: str, because: str, try_this: str = VALUE_AS_IT_CAME) -> Verdict:
        return see.partial(cause, 0.5, saw, ONE_EACH, because, try_this)

    if finite and all(names(told, -one) for one, told in finite):
        return partly("one-alarm.sign-lost", "The sign of the value is missing or wrong.")
    if finite and all(names_as_share(told, one) for one, told in finite):
        return partly("one-alarm.value-divided", "The value is divided by 100. The readings are in percent.")
    if finite and all(names_as_whole(told, one) for one, told in finite):
        return partly(
            "one-alarm.value-rounded",
            "The value is rounded to a whole number, so a reading just outside the range looks good.",
        )
    if finite and all(names_one_of(said.readings, told) and not names(told, one) for one, told in finite):
        return partly(
            "one-alarm.names-another-reading",
            "The value in this text belongs to another reading: an earlier one, or the same reading in every text.",
        )
    return partly(
        "one-alarm.value-not-named",
        "This text must help a person find the fault, and the value is the best clue.",
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
    said = said_readings(recording)
    readings = tuple(said.bad[place] for place in missed)
    saw = (
        f"no alarm for {len(missed)} of {len(said.bad)} bad readings, the first of them {shown(readings[0])}"
    )
    ended = ended_with_an_error(recording, saw, ONE_EACH)
    if ended is not None:
        return ended
    if made_late(recording, ALARM) and readings == said.bad[: len(missed)]:
        return first_alarms_lost(saw)
    if len(set(passed_on(recording).lost)) > len(said.good) // 2:
        return perhaps_not_called(saw)
    if missed == tuple(range(1, len(said.bad))):
        return see.failed(
            "one-alarm.first-only",
            saw,
            ONE_EACH,
            "Only the first bad reading raises an alarm, because your node stores that it has raised one.",
            "Publish an alarm for each bad reading, no matter what the previous ones were.",
            about_time=True,
        )
    if set(missed) == said.bad_in_a_row:
        return see.failed(
            "one-alarm.one-in-a-row",
            saw,
            ONE_EACH,
            "Of several bad readings in a row, only the first raises an alarm.",
            "Publish an alarm for each bad reading, no matter what the previous ones were.",
            about_time=True,
        )
    return why_no_more_come(recording, saw, missed) or why_a_kind_is_missing(said, saw, missed)


def why_no_more_come(recording: Recording, saw: str, missed: tuple[int, ...]) -> Verdict | None:
    """Why there are alarms for such readings at first only, or now and then; None if they are of kinds of their own."""
    said = said_readings(recording)
    came = {repr(one) for n, one in enumerate(said.bad) if n not in missed}
    if missed == tuple(range(missed[0], len(said.bad))) and recording.process.ended_by == "itself":
        return see.failed(
            "one-alarm.ended",
            f"{saw}. Your program had already ended",
            ONE_EACH,
            "The program ends by itself after a while.",
            "Spin until the program is stopped: rclpy.spin(node).",
            about_time=True,
        )
    if set(missed) == said.said_before:
        return see.failed(
            "one-alarm.equal-once",
            saw,
            ONE_EACH,
            "Each of them is equal to an earlier bad reading that raised an alarm.",
            "Publish an alarm for each bad reading, no matter what the previous ones were.",
            about_time=True,
        )
    if not came & {repr(said.bad[place]) for place in missed}:
        return None
    return see.failed(
        "one-alarm.not-each",
        saw,
        ONE_EACH,
        "An equal reading did raise an alarm. So the alarm also depends on something else, such as a counter or an "
        "earlier reading. Or several readings share an alarm.",
        "Publish an alarm for each bad reading, no matter what the previous ones were.",
        about_time=True,
    )


def why_a_kind_is_missing(said: Readings, saw: str, missed: tuple[int, ...]) -> Verdict:
    """Why no alarm came for bad readings of one kind, or of several."""
    readings = tuple(said.bad[place] for place in missed)
    kinds = kinds_of(readings)
    if set(readings) <= said.near_limits:
        return see.failed(
            "one-alarm.tolerance",
            saw,
            ONE_EACH,
            "Only readings very close to 0 or 100 raise no alarm. Your limits are a little wider, or the reading "
            "is rounded before the comparison.",
            ASK_WHAT_IS_GOOD,
            about_time=True,
        )
    if kinds == {"nan"}:
        return see.failed(
            "one-alarm.missed",
            saw,
            ONE_EACH,
            "nan is not a number, and every comparison with it is False: nan < 0, nan > 100, and even nan == nan.",
            "Test whether the reading is good, 0.0 <= message.data <= 100.0, and raise the alarm if it isn't.",
        )
    if kinds == {"inf"}:
        return see.failed(
            "one-alarm.infinite-missed",
            saw,
            ONE_EACH,
            INFINITE_IS_BAD,
            "Test whether the reading is good, 0.0 <= message.data <= 100.0, and raise the alarm if it isn't.",
        )
    return see.failed(
        "one-alarm.kinds-missed",
        saw,
        ONE_EACH,
        "Not every kind of bad reading raises an alarm. A bad reading may be below 0, above 100, or not a number.",
        "Test whether the reading is good, 0.0 <= message.data <= 100.0, and raise the alarm if it isn't.",
        about_time=True,
    )


DECIDE_BY_THIS_ONE = "Test only the current reading: 0.0 <= message.data <= 100.0."
NO_FALSE_ONES = "no alarm for a good reading"


def names_an_earlier_one(saw: str) -> Verdict:
    """The alarm came with a good reading, and is about a bad one."""
    return see.failed(
        "no-false-alarm.names-an-earlier-one",
        saw,
        NO_FALSE_ONES,
        "Your node published this text for a good reading, but it contains an earlier bad one. Any text on this "
        "topic is an alarm.",
        "Publish on this topic only if the current reading is bad.",
    )


def names_a_number(text: str) -> bool:
    """Also one that is none, or infinite."""
    return bool(numbers_in(text)) or names_one_of((math.nan, math.inf, -math.inf), text)


def names_no_reading(saw: str) -> Verdict:
    """The alarms came with good readings, and name none."""
    return see.failed(
        "no-false-alarm.names-no-reading",
        saw,
        NO_FALSE_ONES,
        "Your node published this text for a good reading, and it contains no reading. Any text on this topic is "
        "an alarm, even one that reports that all is well.",
        "Publish on this topic only if the current reading is bad.",
    )


def many_false_alarms(saw: str, *, before_bad: bool) -> Verdict:
    """Why there were alarms for most of the good readings. `before_bad`: even before the first bad one."""
    if before_bad:
        return see.failed(
            "no-false-alarm.every-reading",
            saw,
            NO_FALSE_ONES,
            "Your node publishes texts on this topic for good readings, too, even before the first bad one.",
            "Publish on this topic only if a reading is bad.",
        )
    return see.failed(
        "no-false-alarm.goes-on",
        saw,
        NO_FALSE_ONES,
        "After the first alarm, your node raises an alarm for most good readings, too.",
        DECIDE_BY_THIS_ONE,
    )


def why_false_alarms(found: Alarms, said: Readings) -> Verdict:
    """Why there were alarms for good readings."""
    false = found.false
    saw = f"{see.count(len(false), 'extra alarm')}, the first {quoted(false[0])}"
    expected = NO_FALSE_ONES
    about_bad = [
        text for text in false if names_one_of(said.bad, text) and not names_one_of(said.inside, text)
    ]
    if len(about_bad) == len(false) and not all(names_one_of(said.good, text) for text in false):
        return names_an_earlier_one(saw)
    if any(names(false[0], said.good[place]) for place in said.low if said.good[place]):
        return see.failed(
            "no-false-alarm.low-charge",
            saw,
            expected,
            "A low battery is bad news, but not a bad reading.",
            DECIDE_BY_THIS_ONE,
        )
    if len(false) <= len(said.good) // 2 and not any(names_a_number(text) for text in false):
        return names_no_reading(saw)
    if len(false) > len(said.good) // 2:
        return many_false_alarms(saw, before_bad=found.before_bad)
    return see.failed(
        "no-false-alarm.good-reading",
        saw,
        expected,
        "Readings from 0 to 100 % are good, including both limits, no matter what the previous readings were.",
        DECIDE_BY_THIS_ONE,
    )


# --- what may explain both ----------------------------------------------------------------------------------

MADE_LATE = (
    "The publisher is created in the callback. Subscriptions need a moment to discover it, so earlier messages are "
    "lost.",
    "Create publishers once, in __init__, and only use them in the callback.",
)


def made_late(recording: Recording, one: Topic) -> bool:
    """Whether the publisher was made only when readings were coming in already."""
    seen = recording.topic(one.name).publishers
    first_said = min((word.t for word in recording.published), default=0.0)
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
