"""Judge exercise 11 by the program's reports on sixty numbered touches, and by the time of each report."""

import math
import random
import statistics
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from std_msgs.msg import Int32

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, program_runs, topic, watching

TOUCH = "/robot/touch"
SEEN = topic("/monitor/seen", Int32)
WORDS = see.Words(__file__)

IN_A_RUN, IN_A_BUNCH = 8, 11  # the numbers of touches that come one by one, and at the same time
PAUSE_S = 2.0  # a longer time without a touch is the script's pause, which lasts three seconds
REPORTED_BY_S = 0.25  # by this time after the last touch, a program is idle

# A callback needs 1 ms, or 2 ms on a busy machine. A program that polls every 20 ms is up to 20 ms late.
ALONE_MS, ALONE_SHARE = 10.0, 0.75
TOGETHER_MS = 200.0  # for half of a bunch: far more than 11 callbacks need, less than 11 sleeps of 0.05 s
MOSTLY = 0.7
AT_ONCE_S = 0.02
TOO_LATE_MS = 300.0  # longer than polling every 0.2 s can explain, so the touch waited in a queue
EARLY_S = 0.001
PROCESSOR_SHARE = 0.05
NEVER_WAITS_SHARE = 0.4
WAITED_S = 0.1  # in the run queue: on an otherwise idle machine, a program waits a tenth of that


def drawn(rng: random.Random) -> list[see.Part]:
    """Draw the script of sixty touches: eight single ones, two bunches, eight single ones, and two more bunches.

    The last bunch follows after a pause of 3 s. The intervals (s) between single touches are longer than the starter's
    sleep and out of step with that sleep.
    """
    spacing = rng.uniform(0.223, 0.233)
    run, bunch = [spacing * n for n in range(IN_A_RUN)], [0.0] * IN_A_BUNCH
    moments = [0.0]
    for least, most, block in (
        (0.35, 0.45, run),
        (0.25, 0.3, bunch),
        (0.3, 0.33, bunch),
        (0.47, 0.52, run),
        (0.28, 0.33, bunch),
        (3.0, 3.1, bunch),
    ):
        begin = moments[-1] + rng.uniform(least, most)
        moments += [begin + after for after in block]
    return [see.publish(TOUCH, Int32, list(zip(moments[1:], drawn_numbers(rng), strict=True)))]


def drawn_numbers(rng: random.Random) -> list[int]:
    """Draw the touches' numbers.

    The numbers begin above 1000, and skip one number and then many, or many and then one. They restart at 1 three
    times: twice in a row among the single touches, and in the middle of the last bunch. So 1 occurs twice in a row, and
    the first numbers occur again. The numbers before the last restart are greater than those after it. The size of a
    bunch is one of the numbers, but only after the first two bunches.
    """
    great, last = rng.randint(34, 36), rng.randint(6, 9)
    small = 2 * IN_A_RUN + 4 * IN_A_BUNCH - great - 1 - last
    skips = [1, rng.randint(40, 60)]
    rng.shuffle(skips)
    one, other = rng.randint(3, 14), rng.randint(17, great - 3)
    first = rng.randint(1003, 1200)
    numbers = [first + n + skips[0] * (n >= one) + skips[1] * (n >= other) for n in range(great)]
    return [*numbers, 1, *range(1, small + 1), *range(1, last + 1)]


WATCH = watching(wall_seconds=9.0, script=drawn)


class Touches:
    """The touches, each identified by its place in the script (from 0), and their reports."""

    def __init__(self, recording: Recording) -> None:
        self.recording, self.in_line_s = recording, recording.in_line_s
        script = see.script(recording, TOUCH)  # including touches that were still due when the program exited
        self.sent = [one.value["data"] for one in script]
        self.came = [(one.value["data"], one.wall) for one in see.published(recording, TOUCH)]
        arrivals = recording.topic(SEEN.name).arrivals
        self.reports = [(arrival.value["data"], arrival.published) for arrival in arrivals]
        self.numbers = [number for number, _ in self.reports]
        self.places = self.found_places()

        # the pause (s) before each touch except the first, and the touches that came alone
        pauses = {n: after.t - before.t for n, (before, after) in enumerate(pairwise(script), start=1)}
        around = enumerate(pairwise([1.0, *pauses.values(), 1.0]))
        self.alone = {place for place, both in around if min(both) > AT_ONCE_S}
        singly = [pause for place, pause in pauses.items() if {place, place - 1} <= self.alone]
        self.apart_ms = 1000.0 * statistics.median(singly or [0.0])
        self.after_the_pause = next((place for place, pause in pauses.items() if pause > PAUSE_S), None)
        # the difference between each number and the previous one, and the place of the first number that isn't greater
        steps = [1, *(number - before for before, number in pairwise(self.sent))]
        self.restart = next((place for place, step in enumerate(steps) if step <= 0), 0)
        self.greatest = max(self.sent, default=0)
        self.above_60 = [place for place, number in enumerate(self.sent) if number > 60]

        self.missed = sorted({*range(len(self.sent))} - {*self.places})
        self.missed_steps = [steps[place] for place in self.missed]
        self.missed_numbers = some([self.sent[place] for place in self.missed])
        count, missed_count = len(self.sent), len(self.missed)
        self.nothing_more = self.missed == [*range(count - missed_count, count)]
        self.last_number = [self.sent[place - 1] for place in self.missed[:1]]
        self.together = sum(place not in self.alone for place in self.missed)
        most = "all of them" if self.together == missed_count else "most of them"
        self.which_together = "it" if missed_count == 1 else most

        # the reported numbers that no touch has, those reported too early, and those reported too often
        self.strange = [number for number in self.numbers if number not in self.sent]
        self.has_all = {*self.sent} <= {*self.numbers}
        self.is_cut_off = self.numbers == [number % 256 for number in self.sent]
        first = dict(reversed(self.came))
        self.early = [n for n, at in self.reports if at < first.get(n, -math.inf) - EARLY_S]
        unmatched = {n for n, place in zip(self.numbers, self.places, strict=True) if place is None}
        self.twice = sorted(unmatched - {*self.early})
        self.twice_numbers = some(self.twice)
        # the numbers of two reports in a row that are in the wrong order
        pairs = pairwise([place for place in self.places if place is not None])
        sent = [(self.sent[a], self.sent[b]) for a, b in pairs if b < a]
        self.back = [(one, other) for one, other in sent if one != other]

        # the time (s) of each touch's report; if wrong numbers are reported, but as many as there were touches, the
        # first report belongs to the first touch, and so on
        others = self.strange and len(self.numbers) == count
        places = range(count) if others else self.places
        moments = {n: at for n, (_, at) in zip(places, self.reports, strict=True) if n is not None}
        came = enumerate(self.came)
        self.late_ms = {n: 1000.0 * (moments[n] - wall) for n, (_, wall) in came if n in moments}
        self.alone_ms = [late for place, late in self.late_ms.items() if place in self.alone]
        together_ms = [late for place, late in self.late_ms.items() if place not in self.alone]
        self.half_ms = statistics.median(together_ms or [0.0])
        self.all_ms = statistics.median(self.late_ms.values() or [0.0])
        self.typical_ms = statistics.median(self.alone_ms or [self.half_ms])
        self.soon = sum(late <= ALONE_MS for late in self.alone_ms)
        self.is_late = self.soon < ALONE_SHARE * len(self.alone_ms)
        # whether single touches were mostly reported at the same time as others, or all equally late
        at_s = sorted(moment for place, moment in moments.items() if place in self.alone)
        self.are_collected = sum(b - a < AT_ONCE_S for a, b in pairwise(at_s)) >= MOSTLY * len(at_s)
        near = sum(abs(late - self.typical_ms) < 0.1 * self.typical_ms for late in self.alone_ms)
        self.are_evenly_late = near >= ALONE_SHARE * len(self.alone_ms)

        # the used fraction of a processor in the pause, or in the whole watch if there was no pause
        walls = [wall for _, wall in self.came]
        place = self.after_the_pause or len(walls)
        span = (walls[place - 1] + REPORTED_BY_S, walls[place]) if place < len(walls) else ()
        share = see.processor_share(recording, *span)
        self.processor = math.nan if share is None else share

    def found_places(self) -> list[int | None]:
        """Return the place of each report's touch, or None if no touch fits.

        A touch fits a report if it has the reported number, came before the report, and has no report yet. If several
        touches fit, choose the first one after the touch that was reported last; if two touches in a row have the same
        number, choose the second. Without such a touch, choose the latest one that fits.
        """
        found: list[int | None] = []
        free, last = dict(enumerate(self.came)), -1
        for number, at in self.reports:
            fit = [n for n, (one, wall) in free.items() if one == number and wall - EARLY_S <= at]
            place = next((n for n in fit if n > last and n + 1 not in fit), fit[-1] if fit else None)
            found.append(place)
            if place is not None:
                del free[place]
                last = place
        return found


def some(numbers: Sequence[int]) -> str:
    """Return the first four of these numbers as a string, with "…" if there are more."""
    return ", ".join([*map(str, numbers[:4]), *(["…"] if len(numbers) > 4 else [])])


TOUCHES = see.once(Touches)
NO_REPORT = WORDS.cause("none-missed.no-report", Touches)
MISSED = WORDS.rules(
    Touches,
    "none-missed",
    ("cut-off", lambda f: f.strange and f.is_cut_off),
    ("no-touch", lambda f: f.strange),
    ("the-first", lambda f: f.missed == [0]),
    ("after-the-pause", lambda f: f.missed == [f.after_the_pause]),
    ("the-last", lambda f: f.missed == [len(f.sent) - 1]),
    ("smaller-numbers", lambda f: f.nothing_more and f.missed[0] == f.restart),
    ("greater-numbers", lambda f: f.missed[1:] and f.missed == f.above_60),
    ("number-known", lambda f: 0 in f.missed_steps and all(f.sent[n] in f.sent[:n] for n in f.missed)),
    ("after-a-gap", lambda f: max(f.missed_steps) > 1 and 1 not in f.missed_steps),
    ("at-the-restart", lambda f: max(f.missed_steps) <= 0 and f.restart in f.missed),
    ("cannot-keep-up", lambda f: f.all_ms > TOO_LATE_MS),
    ("nothing-more", lambda f: f.nothing_more and f.missed[0] > 0, see.ended_by_error),
    ("nothing", lambda f: f.nothing_more and f.missed[0] == 0, see.ended_by_error),
    ("ended", lambda f: f.nothing_more and f.missed[0] > 0 and f.recording.process.ended_by == "itself"),
    ("stops", lambda f: f.nothing_more and f.missed[0] > 0),
    ("came-together", lambda f: f.together >= MOSTLY * len(f.missed)),
    ("polls", see.otherwise),
    about_time=["cannot-keep-up", "came-together", "polls"],
)
NOT_AT_ALL = WORDS.seen("once-in-order.not-at-all", Touches)
NOT_IN_ORDER = WORDS.rules(
    Touches,
    "once-in-order",
    ("gap-filled", lambda f: f.strange and f.has_all and all(0 < n < f.greatest for n in f.strange)),
    ("something-else", lambda f: f.strange and f.has_all),
    ("cut-off", lambda f: f.strange and f.is_cut_off),
    ("no-touch", lambda f: f.strange),
    ("twice", lambda f: f.twice),
    ("besides-all", lambda f: f.early and not f.missed),
    ("ahead", lambda f: f.early),
    ("sorted", lambda f: f.back and all(b > a for a, b in f.back)),
    ("other-order", lambda f: f.back),
)
NOT_REPORTED = WORDS.cause("quick.nothing-reported", ())
NOT_QUICK = WORDS.rules(
    Touches,
    "quick",
    ("collected", lambda f: f.is_late and f.are_collected),
    ("with-the-next", lambda f: f.is_late and abs(f.typical_ms - f.apart_ms) < ALONE_MS),
    ("busy-machine", lambda f: f.is_late and f.typical_ms < 3.0 * ALONE_MS and f.in_line_s > WAITED_S),
    ("held-back", lambda f: f.is_late and f.are_evenly_late),
    ("polls", lambda f: f.is_late and f.typical_ms < TOO_LATE_MS),
    ("falls-behind", lambda f: f.is_late),
    ("cannot-keep-up", lambda f: f.half_ms > TOGETHER_MS),
    about_time=True,
)
NOT_EASY = WORDS.rules(
    Touches,
    "easy-on-processor",
    ("never-waits", lambda f: f.processor >= NEVER_WAITS_SHARE),
    ("wants-more", lambda f: f.processor + f.in_line_s / f.recording.watched_s > NEVER_WAITS_SHARE),
    ("wakes-too-often", see.otherwise),
)


@criterion(
    points=1, title="It subscribes to /robot/touch and publishes on /monitor/seen", needs=[program_runs]
)
def topics(recording: Recording) -> Verdict:
    return see.all_of(see.listens(recording, topic(TOUCH, Int32)), see.publishes(recording, SEEN))


@criterion(points=3, title="No touch is missed", needs=[topics])
def none_missed(recording: Recording) -> Verdict:
    touches, nothing = TOUCHES(recording), see.no_message(recording, SEEN)
    if nothing is not None:
        told = NO_REPORT.verdict(touches)
        if "Error" in nothing.saw:
            return replace(told, cause=nothing.cause, because=nothing.because)
        return see.asks_for_other_qos(recording, TOUCH, told.saw, told.expected) or told
    well = see.passed(f"all {len(touches.sent)} touches reported")
    return MISSED.verdict(touches) if touches.missed else well


@criterion(points=2, title="No touch is reported twice, and the reports are in order", needs=[topics])
def once_in_order(recording: Recording) -> Verdict:
    touches, nothing = TOUCHES(recording), see.no_message(recording, SEEN)
    if nothing is not None:
        saw, expected = NOT_AT_ALL(touches)
        try_this = "Publish in the subscription's callback."
        return see.failed(nothing.cause, saw, expected, nothing.because, try_this)
    return NOT_IN_ORDER.first(touches) or see.passed(f"{len(touches.numbers)} reports, in order")


@criterion(points=2, title="Each report is published within a few milliseconds", needs=[topics])
def quick(recording: Recording) -> Verdict:
    touches = TOUCHES(recording)
    if not touches.late_ms:
        return NOT_REPORTED.verdict()
    return NOT_QUICK.first(touches) or see.passed(f"typically {touches.typical_ms:.1f} ms")


@criterion(points=1, title="It uses hardly any CPU time", needs=[topics])
def easy_on_processor(recording: Recording) -> Verdict:
    touches = TOUCHES(recording)
    if touches.processor > PROCESSOR_SHARE:
        return NOT_EASY.verdict(touches)
    unknown = math.isnan(touches.processor)
    return see.passed("hardly any CPU time" if unknown else f"{touches.processor:.0%} of a processor")


@criterion(points=1, title="The program is still running at the end", needs=[program_runs])
def alive_at_end(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)
