"""Judge exercise 13: a robot publishes its status before the dashboard starts, and its heartbeat pauses twice."""

import math
import random
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import accumulate, cycle, pairwise, product
from typing import NamedTuple, TypeVar

from std_msgs.msg import Bool, String

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, program_runs, topic, watching

LINE = topic("/dashboard/line", String, hz=2.0)
ALARM = topic("/dashboard/alarm", Bool)
WORDS = see.Words(__file__)
Value = TypeVar("Value")
Timed = list[tuple[float, Value]]  # messages with their arrival times (s)

WATCH_S = 15.0
BEAT_S, LINE_S = 0.25, 0.5
STATUS = see.publish("/robot/status", String, [], qos="latched")
HEART = see.publish("/robot/heartbeat", String, [], qos="best_effort", deadline=2 * BEAT_S)

STATUS_WORDS = ("operational", "error", "unknown")
AT_ONCE_S = 1.0  # by then, the line must show the status that was published earlier
FOLLOWS_S = 0.8
NOT_BEFORE_S, NOT_AFTER_S, SLACK_S = 1.0, 3.0, 0.2
FALLS_WITHIN_S = 1.5
EARLY_S = 0.02  # a True that's early by at most this isn't a false alarm, because times are inexact
SILENCE_S = 2.0  # a longer pause between heartbeats is one of the script's silences
SLOWEST_HZ, FASTEST_HZ, LONGEST_GAP_S = 1.8, 2.2, 1.25
SHORTEST_S, LONGEST_S = 0.45, 0.55
LASTS_S = FOLLOWS_S + LONGEST_S  # a status that lasts longer must be on a line
NEAR_S = 0.7  # the most time from the last line to the alarm with which the line stops


def drawn(rng: random.Random) -> list[see.Part]:
    """Draw the script of a robot that published before the start.

    The robot's heartbeat pauses twice, and one heartbeat is late.

    A program that checks the time five times a second detects the two silences at different phases. After the second
    silence, there is time to end an alarm.
    """
    while True:
        moments = drawn_beats(rng)
        silences = silences_between(moments)
        (first, _), (second, ended) = silences
        if ended > WATCH_S - 1.8 or abs((second - first) % 0.2 - 0.1) > EARLY_S:
            continue
        changes = drawn_changes(rng, silences)
        moments_of_change = [*(at for at, _ in changes[1:]), WATCH_S]
        lasting = [at for at, end in pairwise(moments_of_change) if end - at > LASTS_S]
        # a program whose line follows late has to miss one of these statuses
        if any(0.2 < (one - other) % LINE_S < 0.3 for one, other in product(lasting, lasting)):
            break
    beats = [(at, f"beat {n + 1}") for n, at in enumerate(moments) if at < WATCH_S - 0.1]
    return [
        replace(STATUS, lines=see.publish(STATUS.topic, String, changes).lines),
        replace(HEART, lines=see.publish(HEART.topic, String, beats).lines),
    ]


def drawn_beats(rng: random.Random) -> list[float]:
    """Draw the times (s) of the heartbeats: three groups with silences in between, and a late heartbeat (a hiccup).

    The hiccup is in one of the first two groups. The first group, or its part before the hiccup, lasts longer than a
    second.
    """
    counts = [rng.randint(6, 18), rng.randint(4, 8), 30]
    hiccup = rng.choice((rng.randint(5, counts[0] - 1), counts[0] + rng.randint(1, counts[1] - 1)))
    pauses = {hiccup: rng.choice((0.85, 0.9))}
    pauses |= {sum(counts[:group]): rng.choice((3.7, 3.75, 3.8)) for group in (1, 2)}
    return [*accumulate(pauses.get(n, BEAT_S) if n else 0.0 for n in range(sum(counts)))]


def drawn_changes(rng: random.Random, silences: Sequence[tuple[float, float]]) -> list[tuple[float, str]]:
    """Draw the status from before the start, and the times (s) and words of its changes.

    There are too many changes for a program that follows only five. When an alarm is due, the status is "operational"
    in the first silence and "error" in the second. The status stays the same until the alarm would be late, and changes
    before the silence ends. When the alarm has to end, the status is "error" after the first silence, and changes only
    when the end would be late. After the second silence, the status is "operational". In the second silence, the status
    changes so often that a watchdog that counts a status as a heartbeat doesn't raise an alarm.
    """
    (began, ended), (again, at_last) = silences
    changes = [
        began + rng.uniform(0.6, 0.9),
        ended - rng.uniform(0.2, 0.3),
        ended + rng.uniform(1.8, 1.9),
        again + rng.uniform(1.55, 1.65),
        again + rng.uniform(3.26, 3.3),
    ]
    words = ["error", "operational"]
    before, after, latest = changes[0] - LASTS_S, at_last + 1.8, WATCH_S - LASTS_S - 0.05
    if before > 1.6 and rng.random() < 0.7:
        changes.insert(0, rng.uniform(1.6, before))
        words.reverse()
    if after < latest and rng.random() < 0.5:
        changes.append(rng.uniform(after, latest))
    return list(zip([see.BEFORE_START, *changes], cycle(words), strict=False))


def silences_between(moments: Sequence[float]) -> list[tuple[float, float]]:
    """Return the start and end (s) of each long time without a heartbeat."""
    return [(last, first) for last, first in pairwise(moments) if first - last > SILENCE_S]


WATCH = watching(wall_seconds=WATCH_S, script=drawn)


def named(text: str) -> list[str]:
    """Return the status words that a line contains."""
    return [word for word in STATUS_WORDS if word in text.lower()]


def between(begin: float, end: float, messages: Timed[Value]) -> Timed[Value]:
    return [(t, value) for t, value in messages if begin <= t < end]


class FalseAlarm(NamedTuple):
    """An alarm that was raised at the time `at` (s), only `after` seconds after a heartbeat.

    `first`: how long (s) an earlier silence had lasted when the program raised its first alarm in it, or 0 without such
    an alarm.
    """

    at: float
    after: float
    first: float


class Status:
    """A status of the robot, its start and end (s), and the lines published for it. `number`: its index, from 0."""

    def __init__(self, run: "Run", number: int, begin: float, end: float, word: str) -> None:
        self.run, self.number, self.begin, self.end, self.word = run, number, begin, end, word
        self.due = begin + FOLLOWS_S if number else AT_ONCE_S  # from then on, the line must show the status
        self.lines = between(self.due, end, run.lines)
        before = between(self.due - LONGEST_S, self.due, run.lines)[-1:] if number else []
        judged = [*before, *self.lines] if end - begin > FOLLOWS_S else []
        # the first line that must show only this status but doesn't, and the status words in that line
        self.wrong = next((line for line in judged if named(line[1]) != [word]), None)
        self.named = named(self.wrong[1]) if self.wrong else []

    def is_shown(self, begin: float, end: float) -> bool:
        return any(self.word in named(text) for _, text in between(begin, end, self.run.lines))

    @property
    def followed(self) -> int:
        """The number of earlier changes that the line had shown."""
        return sum(bool(one.lines) for one in self.run.statuses[1 : self.number])


class Silence:
    """A long silence, from the last heartbeat before it to the first one after it (s).

    `number`: the silence's index, from 0.
    """

    def __init__(self, run: "Run", number: int, began: float, ended: float) -> None:
        self.run, self.number, self.began, self.ended = run, number, began, ended
        self.lasted = ended - began
        alarms = between(began, ended, run.alarms)
        self.said = [t - began for t, _ in alarms if t - began >= NOT_BEFORE_S]  # when an alarm is allowed
        self.raised = next((t - began for t, on in alarms if on), math.inf)  # counted from the last heartbeat
        self.is_due = run.end >= began + NOT_AFTER_S + SLACK_S
        self.is_in_time = self.raised <= NOT_AFTER_S + SLACK_S
        # the alarm isn't missed if the previous silence's alarm never ended
        was_on = number and [on for _, on in between(0.0, began, run.alarms)][-1:] == [True]
        self.is_missed = self.is_due and not self.is_in_time and not (was_on and self.raised == math.inf)
        # the times (s) at which the alarm was withdrawn during the silence, and the first of them, counted from the
        # last heartbeat
        self.falls = [t for t, on in alarms if t > began + self.raised and not on]
        self.fell = [t - began for t in self.falls[:1]]
        self.raised_after = any(on for _, on in between(ended, ended + FALLS_WITHIN_S, run.alarms))
        after = between(ended, run.end, run.alarms)
        self.taken_back = next((t - ended for t, on in after if not on), math.inf)  # since the next heartbeat
        limit = FALLS_WITHIN_S + SLACK_S
        self.lasts = self.taken_back > limit and ended + limit <= run.end


class Run:
    """The robot's messages, and the dashboard's messages about them. Times are in s."""

    def __init__(self, recording: Recording) -> None:
        self.recording, self.end = recording, recording.watched_s
        line, alarm = recording.topic(LINE.name), recording.topic(ALARM.name)
        self.lines: Timed[str] = [(one.t, str(one.value.get("data"))[:60]) for one in line.arrivals]
        self.alarms: Timed[bool] = [(one.t, bool(one.value.get("data"))) for one in alarm.arrivals]
        self.beats = [one.t for one in see.published(recording, HEART.topic)]
        sent = see.published(recording, STATUS.topic)
        times = [*(max(0.0, one.t) for one in sent), self.end]  # the first status is valid at the start
        self.statuses = [
            Status(self, n, times[n], times[n + 1], str(one.value["data"])) for n, one in enumerate(sent)
        ]
        silences = silences_between([*self.beats, self.end])  # a last silence lasts until the watch ends
        self.silences = [Silence(self, n, began, ended) for n, (began, ended) in enumerate(silences)]

        # the lines
        with_a_status = [self.just_begun(t, BEAT_S) for t, _ in self.lines if t >= AT_ONCE_S]
        self.with_a_status = len(with_a_status) if all(with_a_status) else 0
        start, end = line.window or (0.0, self.end)
        moments = [start, *(t for t, _ in self.lines), end]
        self.gaps = [(last, next_t) for last, next_t in pairwise(moments) if next_t - last > LONGEST_GAP_S]
        self.gap_times = [f"from {last:.2f} s to {next_t:.2f} s" for last, next_t in self.gaps]
        lasts, raised = [last for last, _ in self.gaps], [t for t, on in self.alarms if on]
        self.stops_with_the_alarm = all(any(-EARLY_S <= t - last <= NEAR_S for t in raised) for last in lasts)
        begins = [one.began for one in self.silences]
        self.stops_with_the_heart = all(any(abs(last - t) <= BEAT_S for t in begins) for last in lasts)
        near = [(t, beat) for t, _ in self.lines for beat in self.beats if 0.0 <= t - beat <= 2 * EARLY_S]
        # the number of heartbeats that a line follows right away, and the number of lines that don't follow a heartbeat
        prompt, beats = {t for t, _ in near}, {beat for _, beat in near}
        self.with_beats = len(beats), sum(t not in prompt for t, _ in self.lines)
        most = self.with_beats[0] >= 0.8 * len(self.beats)
        self.also_with_beats = most and self.with_beats[1] >= SLOWEST_HZ * self.end / 2
        asked = [one for one in recording.topic(STATUS.topic).subscribers if one.type == STATUS.type]
        self.is_volatile = all(one.durability == "volatile" for one in asked)
        self.is_best_effort = all(one.reliability == "best_effort" for one in asked)

        # the number of changes of the alarm, if each change came right after a matching change of the status
        heard = [(0.0, None), *between(AT_ONCE_S, self.end, self.alarms)]
        changes = [(t, on) for (_, before), (t, on) in pairwise(heard) if on != before]
        begun = [(on, self.just_begun(t, BEAT_S + 2 * EARLY_S)) for t, on in changes]
        fits = [all(any(on == (one == word) for one in new) for on, new in begun) for word in STATUS_WORDS]
        self.alarms_with_the_status = len(changes) if any(fits) and len(changes) > 1 else 0
        self.in_time = [one.raised for one in self.silences if one.is_in_time]
        self.ended_by_status = [t for one in self.silences for t in one.falls if self.just_begun(t)]

    def just_begun(self, t: float, within_s: float = BEAT_S - EARLY_S) -> list[str]:
        """Return the new statuses that began at most `within_s` s before `t`."""
        return [one.word for one in self.statuses[1:] if 0.0 <= t - one.begin <= within_s]

    def false_alarms(self) -> Iterator[FalseAlarm]:
        """Yield the alarms that were raised while heartbeats arrived, or too early in a silence."""
        calm_from = AT_ONCE_S
        for silence in self.silences:
            for t, on in between(calm_from, silence.began + NOT_BEFORE_S - EARLY_S, self.alarms):
                after = t - max((beat for beat in self.beats if beat <= t), default=0.0)
                if on and after < NOT_BEFORE_S - EARLY_S:  # on a busy machine, a hiccup may last longer
                    before = [one.raised for one in self.silences if one.ended <= t]
                    yield FalseAlarm(t, after, next(filter(math.isfinite, before), 0.0))
            # This silence's alarm may last until it's withdrawn. `alarm_falls` judges whether that happens.
            calm_from = min(self.end, silence.ended + silence.taken_back)


RUN = see.once(Run)
OTHER_RATE = WORDS.rules(
    Run,
    "line-rate",
    ("only-with-a-status", lambda f: f.with_a_status),
    ("silent", lambda f: f.gaps, see.failed_by_error),
    ("stops-with-the-alarm", lambda f: f.gaps and f.stops_with_the_alarm),
    ("stops-with-the-heart", lambda f: f.gaps and f.stops_with_the_heart),
    ("also-with-each-beat", lambda f: f.also_with_beats),
)
UNEVEN = WORDS.cause("line-rate.uneven", ("count", "hz", "typical_s"), about_time=True)
AT_ONCE = WORDS.rules(
    Status,
    "status-at-once",
    ("no-line", lambda f: not f.lines),
    ("two-words", lambda f: f.word in f.named),
    ("volatile", lambda f: f.wrong and f.run.is_volatile),
    ("best-effort", lambda f: f.wrong and f.run.is_best_effort),
    ("no-word", lambda f: f.wrong and not f.named),
    ("not-kept", lambda f: f.wrong),
    ("guessed", lambda f: f.run.is_volatile),
    about_time=["not-kept"],
)
NOT_FOLLOWED = WORDS.rules(
    Status,
    "status-follows",
    ("two-words", lambda f: f.word in f.named),
    ("unknown-again", lambda f: "unknown" in f.named),
    ("no-word", lambda f: not f.named),
    ("late", lambda f: f.is_shown(f.due, f.end + AT_ONCE_S)),
    ("only-sometimes", lambda f: not f.followed and f.is_shown(f.end, f.run.end)),
    ("not-always", lambda f: f.followed),
    ("never", see.otherwise),
    about_time=["late", "never"],
)
NO_NEW_LINE = WORDS.cause("status-follows.no-line", ())
NOT_RAISED = WORDS.rules(
    Silence,
    "alarm-raised",
    ("with-the-status", lambda f: f.run.alarms_with_the_status),
    ("waits-for-a-status", lambda f: f.run.in_time and f.run.just_begun(f.began + f.raised)),
    ("late", lambda f: f.raised < math.inf),
    ("status-counts", lambda f: f.number and f.run.ended_by_status),
    ("first-only", lambda f: f.number),
    ("inverted", lambda f: f.said and f.raised_after),
    ("with-the-next-beat", lambda f: f.raised_after),
    ("false-instead", lambda f: f.said),
    ("never", see.otherwise),
    about_time=["late", "with-the-next-beat", "never"],
)
EARLY = WORDS.rules(
    FalseAlarm,
    "no-false-alarm",
    ("while-beating", lambda f: f.after <= 1.5 * BEAT_S),
    ("later-one-early", lambda f: f.first >= NOT_BEFORE_S),
    ("early", see.otherwise),
    about_time=True,
)
FALLS = WORDS.rules(
    Silence,
    "alarm-falls",
    ("with-the-status", lambda f: f.falls and f.run.just_begun(f.falls[0])),
    ("in-silence", lambda f: f.falls),
    ("waits-for-a-status", lambda f: f.lasts and f.run.just_begun(f.ended + f.taken_back)),
    ("late", lambda f: f.lasts and f.taken_back < math.inf),
    ("first-only", lambda f: f.lasts and f.number),
    ("never", lambda f: f.lasts),
    about_time=["late"],
)


@criterion(points=0, title="It runs until the judge stops watching", needs=[program_runs])
def runs_on(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)


@criterion(points=1, title="/dashboard/line carries String", needs=[program_runs])
def line_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, LINE)


@criterion(points=1, title="The line is published at 2 Hz, and never stops", needs=[line_topic, runs_on])
@see.needs_messages(LINE)
def line_rate(recording: Recording) -> Verdict:
    run, seen = RUN(recording), see.topic_pace(recording, LINE)
    hz, typical_s = seen.hz or 0.0, seen.typical_interval or 0.0
    even = SHORTEST_S <= typical_s <= LONGEST_S and seen.gap.seconds <= LONGEST_GAP_S
    if SLOWEST_HZ <= hz <= FASTEST_HZ and even:
        return see.passed(f"{hz:.1f} Hz over {seen.count} lines")
    if known := OTHER_RATE.first(run):
        return known
    usual, uneven = see.rate(recording, LINE), UNEVEN.verdict(count=seen.count, hz=hz, typical_s=typical_s)
    return uneven if usual.ok else replace(usual, expected=uneven.expected)


@criterion(
    points=2, title="It shows the status that was published before it started", needs=[line_topic, runs_on]
)
def status_at_once(recording: Recording) -> Verdict:
    hears = see.hears(recording, STATUS)
    if not hears.ok:
        return hears
    first = RUN(recording).statuses[0]
    return AT_ONCE.first(first) or see.passed(f'"{first.word}" on each of {len(first.lines)} lines')


@criterion(points=1, title="The line is updated when the status changes", needs=[status_at_once])
def status_follows(recording: Recording) -> Verdict:
    changes = RUN(recording).statuses[1:]
    for change in changes:
        if change.wrong:
            return NOT_FOLLOWED.verdict(change)
    followed = sum(bool(change.lines) for change in changes)
    if changes and not followed:  # `line_rate` judges whether lines keep coming
        return NO_NEW_LINE.verdict()
    return see.passed(f"the line showed {followed} of {len(changes)} new statuses, and never a wrong one")


@criterion(points=1, title="It receives the heartbeat", needs=[program_runs])
def hears_heartbeat(recording: Recording) -> Verdict:
    return see.hears(recording, HEART)


@criterion(points=0, title="/dashboard/alarm carries Bool", needs=[program_runs])
def alarm_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, ALARM)


@criterion(points=1, title="The alarm is kept for late subscriptions", needs=[alarm_topic])
def alarm_kept(recording: Recording) -> Verdict:
    return see.kept_for_latecomers(recording, ALARM)


@criterion(
    points=1,
    title="The alarm is raised no later than 3 s after the last beat",
    needs=[alarm_topic, hears_heartbeat, runs_on],
)
def alarm_raised(recording: Recording) -> Verdict:
    silences = RUN(recording).silences
    for silence in silences:
        if silence.is_missed:
            return NOT_RAISED.verdict(silence)
    took = [f"{silence.raised:.1f} s" for silence in silences if silence.is_due and silence.is_in_time]
    return see.passed(f"raised {see.listing(took)} after the last beat")


@criterion(points=1, title="The alarm isn't raised too early", needs=[alarm_topic, hears_heartbeat, runs_on])
def no_false_alarm(recording: Recording) -> Verdict:
    for alarm in RUN(recording).false_alarms():
        return EARLY.verdict(alarm)
    return see.passed("no alarm while the heartbeat arrives, nor in the first second of silence")


@criterion(points=1, title="The alarm ends when the heartbeat resumes", needs=[alarm_raised, no_false_alarm])
def alarm_falls(recording: Recording) -> Verdict:
    wrong = (FALLS.first(silence) for silence in RUN(recording).silences)
    return next(filter(None, wrong), None) or see.passed("ended when the heartbeat returned")
