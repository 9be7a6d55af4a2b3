"""Judge exercise 04: send good and bad readings to the monitor, and compare the monitor's messages with the readings.

The readings are drawn for each run. Every draw has certain properties that let us tell the causes below apart.
"""

import math
import re
from bisect import bisect
from collections import Counter, defaultdict
from collections.abc import Callable, Sequence
from difflib import SequenceMatcher
from itertools import accumulate, pairwise, product
from operator import sub
from random import Random

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import Recording, Topic, Verdict, criterion, program_runs, topic, watching

WORDS = see.Words(__file__)
BATTERY, OTHER_BATTERY = "/robot/battery", "/other_robot/battery"
FORWARDED, ALARM = topic("/monitor/battery", Float32), topic("/monitor/alarm", String)

AT_ONCE_S = 0.5  # the task states it
SHARE_AT_ONCE = 0.9  # of the readings, because a busy machine may delay the others

EXAMPLE = -3.0  # the task states it
BIT = 2.0**-13  # 16 times the smallest difference between two 32-bit floats near 100
LIMITS, LOW_AT_MOST, NEAR_LIMIT, JUMP = {0.0, 100.0}, 20.0, 0.5, 10.0
APART_S, MOMENT_S, SAME_MOMENT_S, PAUSE_S, OTHERS_AFTER_S = 0.1, 0.05, 0.01, 1.0, 0.55
EARLIEST_S, LATEST_S, LONGER_GAPS = 0.3, 0.7, 6

# The numbers (from 1) of certain good readings. A battery drains, is replaced by a full one, runs out, and is replaced.
FULL_ONE, FIRST_LOW, EMPTY_ONE, FIRST_AGAIN, LAST_GOOD = 9, 19, 22, 23, 42
AT_ONE_MOMENT, BAD_ONES = 4, 12


def is_good(reading: float) -> bool:
    return 0.0 <= reading <= 100.0


def draining(rng: Random, first: float, count: int, most: float) -> list[float]:
    """Draw `count` falling readings, beginning with `first`. The steps are multiples of 0.25 and at most `most`."""
    steps = [rng.randint(1, round(4 * most)) / 4 for _ in range(count - 1)]
    return [*accumulate(steps, sub, initial=first)]


def drawn_good_ones(rng: Random, equals: Sequence[int]) -> list[float]:
    """Draw all good readings. The readings with the numbers `equals` (from 1) equal the next one; all others differ."""
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
    """Draw the bad readings in rows. No good reading comes between the readings in a row.

    Only a reading that begins a row is sent twice, so an alarm about any other reading fits just that one.
    """
    above, not_finite = rng.randint(420, 780) / 4, [math.inf, math.nan]
    rng.shuffle(not_finite)
    single = [rng.choice((-0.125, -0.25)), 100.0 + BIT, rng.randint(1, 8) * 1e9, -BIT, -math.inf]
    rows = [[EXAMPLE, EXAMPLE], [math.nan], [above, *not_finite], *([one] for one in single)]
    rng.shuffle(rows)
    return [*rows, [above]]


def fits(rows: Sequence[Sequence[float]], slots: Sequence[int]) -> bool:
    """Return whether the `rows` of bad readings can be sent after the good readings with the numbers `slots`.

    Among the values that aren't finite, NaN comes first, but after another alarm, because a monitor that can't handle
    NaN crashes there. At least two good readings lie between rows, to show which bad reading a strange value replaced.
    At least one other row lies between a reading at a limit and the one just beyond that limit, because a rounded alarm
    could mean either reading.
    """
    not_finite = [row[0] for row in rows if not all(map(math.isfinite, row))]
    near = [(FULL_ONE, 100.0 + BIT), (EMPTY_ONE, -BIT)]
    return (
        math.isnan(not_finite[0])
        and not math.isnan(rows[0][0])
        and all(later - slot > 1 for slot, later in pairwise(slots))
        and all(rows.index([beyond]) - bisect(slots, limit - 1) not in (-1, 0) for limit, beyond in near)
    )


def drawn_readings(rng: Random) -> list[tuple[float, float]]:
    """Draw all readings. Return pairs of the time (simulated time, s) at which to send a reading, and the reading."""
    pause, at_one_moment = rng.randint(3, 6), rng.randint(FIRST_AGAIN + 3, LAST_GOOD - 8)
    moment = range(at_one_moment, at_one_moment + AT_ONE_MOMENT)
    later = [n for n in range(FIRST_AGAIN + 1, LAST_GOOD - 2) if not {n, n + 1} & {*moment}]
    equals = [rng.randint(2, 6), rng.choice(later)]
    # No bad reading follows these good readings: before a limit, a monitor may clamp it to that limit, and next to
    # equal readings, replace it by a repetition.
    taken = {pause, FULL_ONE - 1, EMPTY_ONE - 1, moment[0] - 1, *moment, *equals, *(n - 1 for n in equals)}
    free = [n for n in range(3, LAST_GOOD) if n not in taken]
    while True:
        rows = drawn_bad_ones(rng)
        first = rng.choice([n for n in free if n < FULL_ONE - 1])
        others = sorted(rng.sample([n for n in free if n > first], len(rows) - 2))
        slots = [first, *others, LAST_GOOD]
        if fits(rows, slots):
            break
    bad_behind = dict(zip(slots, rows, strict=True))
    longer = rng.sample([n for n in range(1, LAST_GOOD) if n != pause and n not in moment], LONGER_GAPS)
    lines, at = [], rng.randint(round(10 * EARLIEST_S), round(10 * LATEST_S)) / 10
    for number, reading in enumerate(drawn_good_ones(rng, equals), 1):
        # In simulated time, all readings that are due within one step of 0.1 s are sent together.
        before_s = SAME_MOMENT_S * (moment[-1] - number) if number in moment else 0.0
        lines.append((at - before_s, reading))
        at += 0.0 if number in moment[:-1] else APART_S
        at += APART_S if number in longer or number + 1 == moment[0] else PAUSE_S if number == pause else 0.0
        for bad in bad_behind.get(number, ()):
            lines.append((at, bad))
            at += APART_S
    return lines


def drawn(rng: Random) -> list[see.Part]:
    """Draw the script with both robots' readings.

    The other robot's readings are odd multiples of 1/8. Ours in the same range are multiples of 1/4, and so are sums
    and differences of them.
    """
    lines = drawn_readings(rng)
    begin = next(at for (at, _), (later, _) in pairwise(lines) if later - at > PAUSE_S)
    levels = (rng.randint(60, 80), rng.randint(-50, -30), rng.randint(60, 80))
    others = [rng.choice((1, -3, 5)) / 8 + level for level in levels]
    times = (begin + OTHERS_AFTER_S, begin + OTHERS_AFTER_S + 0.1, lines[-1][0] + 0.4)
    theirs = [*zip(times, others, strict=True)]
    return [see.publish(BATTERY, Float32, lines), see.publish(OTHER_BATTERY, Float32, theirs, awaited=False)]


# After the last reading, there's enough time for a timer that repeats the last alarm every second.
GAPS = LAST_GOOD + BAD_ONES - AT_ONE_MOMENT + 1 + LONGER_GAPS
WATCH_S = LATEST_S + APART_S * GAPS + PAUSE_S + 1.4
WATCH = watching(simulated_seconds=WATCH_S, wall_seconds=WATCH_S, script=drawn)


class Readings:
    """The readings of one run.

    Readings with something in common form a set of places among the good or the bad ones.
    """

    def __init__(self, readings: Sequence[float], sent_at: Sequence[float], others: Sequence[float]) -> None:
        self.readings, self.sent_at, self.others = readings, sent_at, others  # others: of the other robot
        self.good_places = [n for n, one in enumerate(readings) if is_good(one)]
        self.bad_places = [n for n, one in enumerate(readings) if not is_good(one)]
        self.good = good = [readings[n] for n in self.good_places]
        self.bad = bad = [readings[n] for n in self.bad_places]
        self.below, self.above = {one for one in bad if one < 0.0}, {one for one in bad if one > 100.0}
        self.near_limits = {one for one in bad if -NEAR_LIMIT < one < 100.0 + NEAR_LIMIT}
        self.changes = [math.nan, *(one - last for last, one in pairwise(good))]  # from the previous reading
        self.equal = {n for n, change in enumerate(self.changes) if change == 0.0}
        self.jumps = {n for n, change in enumerate(self.changes) if abs(change) > JUMP}
        self.risen = {n for n, one in enumerate(good) if n and one > min(good[:n])}
        self.after_bad = {n for n, place in enumerate(self.good_places) if place - 1 in self.bad_places}
        soon = {n for n, (last, one) in enumerate(pairwise(sent_at), 1) if one - last < MOMENT_S}
        self.in_a_moment = {n for n, place in enumerate(self.good_places) if {place, place + 1} & soon}
        self.sent_before = {n for n, one in enumerate(bad) if repr(one) in map(repr, bad[:n])}
        self.bad_in_a_row = {n for n, place in enumerate(self.bad_places) if place - 1 in self.bad_places}

    def bad_before(self, place: int, arrived: Sequence[float]) -> int:
        """Count the bad readings right before the good reading at `place`.

        If all values in `arrived` equal that good reading, use the next good reading that differs from them.
        """
        while place < len(self.good) and {self.good[place]} == set(arrived):
            place += 1
        ends = [-1, *self.good_places, len(self.readings)]
        return ends[place + 1] - ends[place] - 1


def kinds_of(bad: Sequence[float]) -> set[str]:
    return {str(abs(one)) if not math.isfinite(one) else "finite" for one in bad}


class Answers:
    """The monitor's messages on one topic, and the script: readings sent, or still due when the monitor exited."""

    def __init__(self, recording: Recording, answer: Topic) -> None:
        self.recording, self.at_once_s = recording, AT_ONCE_S
        ours, others = see.script(recording, BATTERY), see.script(recording, OTHER_BATTERY)
        levels, theirs = ([one.value["data"] for one in some] for some in (ours, others))
        self.sent = Readings(levels, [one.t for one in ours], theirs)
        self.has_ended = recording.process.ended_by == "itself"
        first_sent = min((word.t for word in recording.published), default=0.0)
        publishers = recording.topic(answer.name).publishers
        self.made_late = bool(publishers) and all(one.first_seen > first_sent for one in publishers)


NUMBER = re.compile(r"(?<![\w.])[-+]?\d{1,99}(?:[.,]\d+)?(?:[eE][-+]?\d\d?)?")  # no overflow
IN_GROUPS = re.compile(r"(?<![\w.,])[-+]?\d{1,3}(?:,\d{3})+(?:\.\d+)?(?![\d,])")
NO_NUMBER = re.compile(r"\bnan\b|not a number", re.IGNORECASE)
INFINITE = re.compile(r"(-|\bminus |\bnegative |)\binf(?:inity|inite)?\b", re.IGNORECASE)
AS_ROUNDED = 0.05 + 1e-6  # an alarm may state its value with one decimal


class Alarm:
    """A message on /monitor/alarm, and the last reading sent before that message was published."""

    def __init__(self, arrival: see.Arrival, words: Sequence[see.Published], sent: Readings) -> None:
        self.text, self.wall = str(arrival.value.get("data")), arrival.published  # s of wall time
        self.numbers = [  # also with a decimal comma, with an exponent, or with commas between the thousands
            *(float(found.replace(",", ".")) for found in NUMBER.findall(self.text)),
            *(float(found.replace(",", "")) for found in IN_GROUPS.findall(self.text)),
            *(math.nan for _ in NO_NUMBER.findall(self.text)),
            *(-math.inf if sign else math.inf for sign in INFINITE.findall(self.text)),
        ]
        self.names_bad = self.names(*sent.bad)
        ours = ((word.wall, float(word.value["data"])) for word in words if word.topic == BATTERY)
        self.after = see.latest_before(ours, self.wall) or 0.0  # a reading of our robot
        last = see.latest_before(((word.wall, word.topic) for word in words), self.wall)
        names_other, names_good = ({*self.numbers} & one for one in ({*sent.others}, {*sent.good} - LIMITS))
        self.is_about_other = names_other or (last == OTHER_BATTERY and not self.names_bad)
        self.is_about_good = is_good(self.after) or (names_good and not self.names_bad)

    def names(self, *readings: float) -> bool:
        """Return whether the alarm contains one of these readings, exactly or rounded."""
        if any(map(math.isnan, readings)) and any(map(math.isnan, self.numbers)):
            return True
        pairs = product(readings, self.numbers)
        return any(math.isclose(one, number, rel_tol=0.0, abs_tol=AS_ROUNDED) for one, number in pairs)


class Alarms(Answers):
    """The messages on /monitor/alarm, matched with the readings that they're about. Places count the bad readings."""

    def __init__(self, recording: Recording) -> None:
        super().__init__(recording, ALARM)
        sent, bad = self.sent, self.sent.bad
        arrivals = recording.topic(ALARM.name).arrivals
        self.all = [Alarm(one, recording.published, sent) for one in arrivals]
        self.others = [alarm for alarm in self.all if alarm.is_about_other]
        own = [alarm for alarm in self.all if not alarm.is_about_other]

        # match as many bad readings as possible, in order, with an alarm about our robot that names the reading: pairs
        # of places
        best = defaultdict[tuple[int, int], dict[int, int]](dict)  # the pairs from these places on
        for i, j in product(reversed(range(len(bad))), reversed(range(len(own)))):
            both = [{i: j, **best[i + 1, j + 1]}] if own[j].names(bad[i]) else []
            best[i, j] = max(*both, best[i, j + 1], best[i + 1, j], key=len)
        # an alarm whose words are the same for different readings doesn't name any of them
        named = Counter(text for text, _ in {(own[j].text, repr(bad[i])) for i, j in best[0, 0].items()})
        self.pairs = {i: j for i, j in best[0, 0].items() if named[own[j].text] == 1}
        self.missed = [place for place in range(len(bad)) if place not in self.pairs]
        self.missed_readings = [bad[place] for place in self.missed]
        paired = {*self.pairs.values()}
        unpaired = [alarm for n, alarm in enumerate(own) if n not in paired]

        # if there's one alarm per bad reading: the readings whose alarms don't name them, with these alarms
        after_bad = [alarm for alarm in unpaired if not is_good(alarm.after)]
        one_each = len(own) == len(bad) and 2 * len(after_bad) > len(unpaired)
        places = range(len(bad) if one_each else 0)
        misnamed = [(bad[place], own[place]) for place in places if self.pairs.get(place) != place]
        # An alarm may name its reading by chance, so alarms that don't name theirs are better clues. So are alarms
        # about finite readings.
        finite = [(reading, alarm) for reading, alarm in misnamed if math.isfinite(reading)]
        unnamed = [(reading, alarm) for reading, alarm in finite if not alarm.names(reading)]
        self.clues = (unnamed if 2 * len(unnamed) >= len(finite) else finite) or misnamed
        self.name_others = all(
            math.isfinite(reading) and alarm.names(*sent.readings) and not alarm.names(reading)
            for reading, alarm in self.clues
        )

        # alarms about good readings, unless they repeat a due alarm; all other unpaired alarms are repetitions
        due = {own[n].text for n in paired}
        about_good = [alarm for alarm in unpaired if alarm.is_about_good]
        false = {a: None for a in about_good if not (a.names_bad and a.text in due) or a.names(a.after)}
        self.repeated = [alarm for alarm in unpaired if alarm not in false]
        self.false = [] if misnamed else [*false]
        self.most_are_false = len(self.false) > len(sent.good) // 2
        ours = see.published(recording, BATTERY)
        first_bad = min((one.wall for one in ours if not is_good(one.value["data"])), default=math.inf)
        inside = {*sent.good} - LIMITS
        name_bad = all(alarm.names_bad and not alarm.names(*inside) for alarm in self.false)
        self.false_name_earlier = name_bad and not all(alarm.names(*LIMITS) for alarm in self.false)
        self.false_before_bad = any(alarm.wall < first_bad for alarm in self.false)

    def misnamed_as(self, fits: Callable[[float, float], bool]) -> bool:
        """Return whether each alarm in `clues` contains a number that `fits` its reading."""
        return all(any(fits(number, reading) for number in alarm.numbers) for reading, alarm in self.clues)


alarms = see.once(Alarms)


class Forwarded(Answers):
    """The messages on /monitor/battery, compared with the readings sent. Places count the good readings."""

    def __init__(self, recording: Recording) -> None:
        super().__init__(recording, FORWARDED)
        sent = self.sent.good
        self.durabilities = {one.durability for one in recording.topic(BATTERY).subscribers}
        came = [(one.t, one.value.get("data")) for one in recording.topic(FORWARDED.name).arrivals]
        levels = [level for _, level in came if isinstance(level, float)]
        self.others = [level for level in levels if level in self.sent.others]
        own = [level for level in levels if level not in self.sent.others]
        self.good, self.bad = [*filter(is_good, own)], [level for level in own if not is_good(level)]
        self.different_bad = list(dict.fromkeys(f"{level:.7g}" for level in self.bad))

        # the edits that turn the good readings into the readings that arrived: missing places, and the values that
        # arrived instead
        codes = SequenceMatcher(None, sent, self.good, autojunk=False).get_opcodes()
        edits = [(range(i, end), self.good[j:to]) for kind, i, end, j, to in codes if kind != "equal"]
        # in place of bad readings, the monitor may publish as many other values as there are bad readings
        self.has_extra = any(
            new and (gone or len(new) > self.sent.bad_before(gone.start, new)) for gone, new in edits
        )
        self.instead = [] if self.has_extra else [level for _, new in edits for level in new]
        self.lost = [place for gone, _ in edits for place in gone]
        self.lost_levels = [sent[place] for place in self.lost]
        self.came_count = len(sent) - len(self.lost)
        false = alarms(recording).false
        self.lost_with_alarm = [one for one in self.lost_levels if any(alarm.names(one) for alarm in false)]
        self.rest = [*range(min(self.lost, default=0), len(sent))]  # from the first lost reading on
        self.stops = self.lost == self.rest

        self.sent_at = [one.t for one in see.published(recording, BATTERY) if is_good(one.value["data"])]
        self.arrived_at = [t for t, level in came if level in sent and level not in self.sent.others]
        delays = [arrived - t for t, arrived in zip(self.sent_at, self.arrived_at, strict=False)]
        self.long_delays = sorted((delay for delay in delays if delay > AT_ONCE_S), reverse=True)
        count = min(self.lost, default=len(self.sent_at))  # the later readings are missing
        self.are_late = len(self.long_delays) > (1.0 - SHARE_AT_ONCE) * count
        apart = [after - before > APART_S / 2 for before, after in pairwise(self.arrived_at)]
        self.in_groups = 3 * sum(apart) < len(self.arrived_at)  # most readings came along with another one

        relay = see.Relay(sent, self.good)
        self.never_sent, self.repeated, self.misplaced = relay.strange, relay.repeated, relay.misplaced
        self.nearest_sent = [
            min(sent, key=lambda n: abs(n - one), default=one) for one in self.never_sent[:1]
        ]

    def lacks(self, places: set[int]) -> bool:
        """Return whether the missing readings are those at these places, or equal readings."""
        good = list(enumerate(self.sent.good))
        return [one for n, one in good if n not in self.lost] == [one for n, one in good if n not in places]


forwarded = see.once(Forwarded)

WRONG_TOPIC = WORDS.cause("battery-topic.publishes-where-it-listens", ())
NOTHING_FORWARDED = WORDS.rules(
    Forwarded,
    "in-order",
    ("asks-for-old-messages", lambda f: f.durabilities == {"transient_local"}),
    ("publisher-made-late", lambda f: f.made_late),
    ("nothing", see.otherwise, see.program_ended),
    ("nothing-passed-on", see.otherwise),
    about_time=["nothing-passed-on"],
)
TOO_MANY = WORDS.rules(
    Forwarded,
    "in-order",
    ("all-zero", lambda f: set(f.good) == {0.0}),
    ("made-up-first", lambda f: f.good[-len(f.sent.good) :] == f.sent.good),
    ("changed", lambda f: f.never_sent),
    ("repeated", lambda f: f.repeated),
    ("other-order", see.otherwise),
    when=lambda f: f.has_extra,
)
TOO_FEW = WORDS.rules(
    Forwarded,
    "in-order",
    ("by-error", lambda f: f.has_ended, see.failed_by_error),
    ("limits-kept-back", lambda f: set(f.lost_levels) <= LIMITS),
    ("low-kept-back", lambda f: max(f.lost_levels) <= LOW_AT_MOST),
    ("after-bad-kept-back", lambda f: f.lacks(f.sent.after_bad)),
    ("equal-kept-back", lambda f: f.lacks(f.sent.equal)),
    ("jumps-kept-back", lambda f: f.sent.jumps.issuperset(f.lost)),
    ("stops-at-the-bad-one", lambda f: f.stops and f.lost[0] == min(f.sent.after_bad, default=-1)),
    ("taken-for-bad", lambda f: 2 * len(f.lost_with_alarm) > len(f.lost)),
    ("risen-kept-back", lambda f: not f.stops and set(f.lost) == f.sent.risen & {*f.rest}),
    ("ended", lambda f: f.stops and f.has_ended),
    ("first-ones-lost", lambda f: f.lost[0] == 0 and f.made_late),
    ("first-one-lost", lambda f: f.lost == [0]),
    ("held-back", lambda f: f.lost == [len(f.sent.good) - 1]),
    ("stops", lambda f: f.stops and not f.are_late),
    ("in-groups", lambda f: f.stops and f.in_groups),
    ("several-at-once-lost", lambda f: set(f.lost) <= f.sent.in_a_moment),
    ("some-lost", see.otherwise),
    when=lambda f: f.lost,
    about_time=True,
)
LATE = WORDS.rules(
    Forwarded,
    "in-order",
    ("late", lambda f: f.are_late and len(f.arrived_at) == len(f.sent_at)),
    about_time=True,
)
BAD_FORWARDED = WORDS.rules(
    Forwarded,
    "bad-kept-back",
    ("clamped", lambda f: f.instead and set(f.instead) <= LIMITS),
    ("replaced", lambda f: f.instead),
    ("nan-instead", lambda f: kinds_of(f.bad) == {"nan"} and len(f.bad) > sum(map(math.isnan, f.sent.bad))),
    ("passed-on", lambda f: kinds_of(f.bad) == {"nan"}),
    ("tolerance", lambda f: set(f.bad) <= f.sent.near_limits),
    ("infinite-passed-on", lambda f: kinds_of(f.bad) == {"inf"}),
    ("one-limit-missing", lambda f: set(f.bad) in (f.sent.below, f.sent.above)),
    ("other-limit", lambda f: set(f.bad) < f.sent.below or set(f.bad) < f.sent.above),
    ("many-passed-on", see.otherwise),
    when=lambda f: f.instead or f.bad,
)
NO_ALARM = WORDS.seen("one-alarm.nothing", ())
ALARM_MADE_LATE = WORDS.cause("one-alarm.publisher-made-late", ("saw",))
READINGS_MISSING_TOO = WORDS.cause("one-alarm.readings-missing-too", ("saw",), about_time=True)
NO_ALARM_MADE = WORDS.cause("one-alarm.none", ("saw", "bad"), about_time=True)
MISNAMED = WORDS.rules(
    Alarms,
    "one-alarm",
    ("sign-lost", lambda f: f.misnamed_as(lambda n, one: abs(n + one) <= AS_ROUNDED)),
    ("value-divided", lambda f: f.misnamed_as(lambda n, one: abs(100.0 * n / one - 1.0) <= 1e-3)),
    ("value-rounded", lambda f: f.misnamed_as(lambda n, one: n.is_integer() and abs(n - one) < 1.0)),
    ("names-another-reading", lambda f: f.name_others),
    ("value-not-named", see.otherwise),
    when=lambda f: f.clues,
    share=0.5,
)
REPEATED = WORDS.cause("one-alarm.repeated", Alarms)
SOME_MISSED = WORDS.seen("one-alarm.some-missed", Alarms)
MISSED_BY_ERROR = WORDS.seen("one-alarm.by-error", Alarms)
MISSED = WORDS.rules(
    Alarms,
    "one-alarm",
    ("first-only", lambda f: f.missed == [*range(1, len(f.sent.bad))]),
    ("one-in-a-row", lambda f: set(f.missed) == f.sent.bad_in_a_row),
    ("ended", lambda f: f.has_ended and f.missed == [*range(f.missed[0], len(f.sent.bad))]),
    ("equal-once", lambda f: set(f.missed) == f.sent.sent_before),
    ("not-each", lambda f: {repr(f.sent.bad[n]) for n in f.pairs} & {*map(repr, f.missed_readings)}),
    ("tolerance", lambda f: set(f.missed_readings) <= f.sent.near_limits),
    ("missed", lambda f: kinds_of(f.missed_readings) == {"nan"}),
    ("infinite-missed", lambda f: kinds_of(f.missed_readings) == {"inf"}),
    ("kinds-missed", see.otherwise),
    about_time=["first-only", "one-in-a-row", "ended", "equal-once", "not-each", "tolerance", "kinds-missed"],
)
FALSE_ALARM = WORDS.rules(
    Alarms,
    "no-false-alarm",
    ("names-an-earlier-one", lambda f: f.false_name_earlier),
    ("low-charge", lambda f: f.false[0].names(*(one for one in f.sent.good if 0.0 < one <= LOW_AT_MOST))),
    ("names-no-reading", lambda f: not f.most_are_false and not any(alarm.numbers for alarm in f.false)),
    ("every-reading", lambda f: f.most_are_false and f.false_before_bad),
    ("goes-on", lambda f: f.most_are_false),
    ("good-reading", see.otherwise),
    when=lambda f: f.false,
)
OTHER_FORWARDED = WORDS.seen("own-robot-only.forwarded", Forwarded)
OTHER_REPORTED = WORDS.seen("own-robot-only.reported", Alarms)
HEARS_OTHERS = WORDS.cause("own-robot-only.hears-others", ("saw",))


@criterion(
    points=1, title="The program subscribes to /robot/battery with the type Float32", needs=[program_runs]
)
def listens(recording: Recording) -> Verdict:
    return see.listens(recording, topic(BATTERY, Float32))


@criterion(points=1, title="/monitor/battery carries Float32", needs=[program_runs])
def battery_topic(recording: Recording) -> Verdict:
    verdict = see.publishes(recording, FORWARDED)
    return verdict if verdict.ok or not recording.topic(BATTERY).publishers else WRONG_TOPIC.verdict()


@criterion(points=0, title="The program forwards readings", needs=[listens, battery_topic])
def passes_on(recording: Recording) -> Verdict:
    if see.values(recording, FORWARDED):
        return see.passed("readings arrive")
    return NOTHING_FORWARDED.verdict(forwarded(recording))


@criterion(
    points=2,
    title="Every good reading is forwarded right away and in the order of arrival",
    needs=[passes_on],
)
def in_order(recording: Recording) -> Verdict:
    facts = forwarded(recording)
    well = see.passed(f"{len(facts.sent.good)} good readings, right away and in order")
    return TOO_MANY.first(facts) or TOO_FEW.first(facts) or LATE.first(facts) or well


@criterion(points=1, title="Neither a bad reading nor a substitute is forwarded", needs=[passes_on])
def bad_kept_back(recording: Recording) -> Verdict:
    well = see.passed("neither a bad reading nor a substitute was forwarded")
    return BAD_FORWARDED.first(forwarded(recording)) or well


@criterion(points=1, title="/monitor/alarm carries String", needs=[program_runs])
def alarm_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, ALARM)


@criterion(points=0, title="The program raises alarms", needs=[listens, alarm_topic])
def alarms_come(recording: Recording) -> Verdict:
    facts = alarms(recording)
    if facts.all:
        return see.passed("alarms arrive")
    saw, expected = NO_ALARM()
    if facts.made_late:
        return ALARM_MADE_LATE.verdict(saw=saw)
    cause = NO_ALARM_MADE if see.values(recording, FORWARDED) else READINGS_MISSING_TOO
    return see.program_ended(recording, saw, expected) or cause.verdict(saw=saw, bad=len(facts.sent.bad))


@criterion(points=2, title="Each bad reading raises exactly one alarm, with its value", needs=[alarms_come])
def one_alarm(recording: Recording) -> Verdict:
    facts = alarms(recording)
    if facts.clues:
        return MISNAMED.verdict(facts)
    if len(facts.repeated) > len(facts.missed):
        return REPEATED.verdict(facts)
    if not facts.missed:
        return see.passed(f"{len(facts.sent.bad)} alarms for {len(facts.sent.bad)} bad readings")
    error = see.failed_by_error(recording, *MISSED_BY_ERROR(facts)) if facts.has_ended else None
    saw, _ = SOME_MISSED(facts)
    if facts.made_late and facts.missed_readings == facts.sent.bad[: len(facts.missed)]:
        return error or ALARM_MADE_LATE.verdict(saw=saw)
    if len(forwarded(recording).lost) > len(facts.sent.good) // 2:
        return error or READINGS_MISSING_TOO.verdict(saw=saw)
    return error or MISSED.verdict(facts)


@criterion(points=1, title="Good readings raise no alarm", needs=[alarms_come])
def no_false_alarm(recording: Recording) -> Verdict:
    return FALSE_ALARM.first(alarms(recording)) or see.passed("no alarm for a good reading")


@criterion(points=1, title="The program ignores /other_robot/battery", needs=[passes_on])
def own_robot_only(recording: Recording) -> Verdict:
    readings, texts = forwarded(recording), alarms(recording)
    if readings.others or texts.others:
        saw, _ = OTHER_FORWARDED(readings) if readings.others else OTHER_REPORTED(texts)
        return HEARS_OTHERS.verdict(saw=saw)
    count = len(readings.sent.others)
    return see.passed(f"{count} readings of another robot, none of them forwarded or reported")
