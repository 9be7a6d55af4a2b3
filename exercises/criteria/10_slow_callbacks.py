"""Judge exercise 10 by the heartbeat while plans are requested, and by whether each plan is the planner's result."""

import math
import random
import statistics
import struct
from bisect import bisect_left
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from functools import cached_property, lru_cache, partial
from itertools import accumulate, pairwise, product
from typing import NamedTuple

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, program_runs, topic, watching

HEARTBEAT = topic("/robot/heartbeat", String, hz=10.0)
PLAN = topic("/robot/plan", Float32)
REQUESTS = "/robot/plan_request"
WORDS = see.Words(__file__)

FROM_THE_NOTEBOOK_M = 0.7  # one of the distances that the notebook requests
LINK_M = 0.4
PLANNING_S = 0.8
SOONEST_S = 0.78
ALMOST_S = 0.7  # parallel searches finish as far apart as their requests, or nearly at the same time
TOLERANCE_RAD = 1e-6
SEARCHING_RAD = 1e-4  # farther off than the formula's result, but closer than an unfinished search
ALIKE_RAD = 0.06  # close enough to show which request a plan is for

LEAST_SHARE, MOST_SHARE = 0.90, 1.10
TYPICALLY_S = (0.095, 0.105)
STEADY = 0.05  # of the typical interval
FAR_TOO_SLOW = 1.5  # times the period: no additional work takes that long
AVERAGED = 5  # heartbeats per averaged interval, because a search step may delay each a little
LONGEST_SILENCE_S = 0.5
WATCH_S = 9.0


def drawn(rng: random.Random) -> list[see.Part]:
    """Draw the script: three requests, and four more once the planner is idle again.

    Before the first request, only the heartbeat is published. Some requests have to wait for the planner. Among the
    first three, the waiting requests go from far to near. Among the last four, they go from near to out of reach and
    back to the same near distance. A very near request comes twice in a row, the second time to an idle planner.
    """
    out_of_reach = rng.randint(85, 92) / 100
    very_near = drawn_distance(rng, 0.04, 0.09)
    while True:
        once, again = drawn_distance(rng, 0.2, 0.62), drawn_distance(rng, 0.2, 0.62)
        bends = [planned(distance) for distance in (very_near, once, again, FROM_THE_NOTEBOOK_M)]
        # no plan, and no half of a plan, may look like the plan for another distance
        if all(
            (one is other or abs(one - other) > 2.5 * ALIKE_RAD) and abs(one / 2.0 - other) > 1.5 * ALIKE_RAD
            for one, other in product(bends, bends)
        ):
            break
    first = [once, FROM_THE_NOTEBOOK_M]
    rng.shuffle(first)
    distances = [*first, very_near, very_near, again, out_of_reach, again]
    begins = [*accumulate([rng.uniform(0.75, 0.9), rng.uniform(0.15, 0.25), rng.uniform(0.15, 0.25)])]
    begins += accumulate([rng.uniform(3.55, 3.68), *(rng.uniform(0.08, 0.1) for _ in range(3))])
    return [see.publish(REQUESTS, Float32, list(zip(begins, distances, strict=True)))]


def drawn_distance(rng: random.Random, least: float, most: float) -> float:
    """Draw a distance (m) whose plan differs from the exact bend, and from the plan for whole millimeters.

    As a 32-bit float, the distance has the same plan.
    """
    while True:
        distance = round(rng.uniform(least, most), 4)
        [sent] = struct.unpack("f", struct.pack("f", distance))
        plan, others = planned(distance), (bend_for(distance), planned(round(distance, 3)))
        if planned(sent) == plan and all(abs(plan - one) > 1.15 * TOLERANCE_RAD for one in others):
            return distance


WATCH = watching(wall_seconds=WATCH_S, script=drawn)


def bend_for(distance: float) -> float:
    """Return the exact bend of the elbow (rad) that brings the hand to `distance` (m) from the shoulder."""
    return 2.0 * math.acos(min(1.0, distance / (2.0 * LINK_M)))


@lru_cache
def planned(distance: float) -> float:
    """Return the bend (rad) that ElbowPlanner finds for `distance` (m).

    Its twenty steps only approximate the exact bend.
    """
    low, high = 0.0, math.pi
    for _ in range(20):
        middle = (low + high) / 2.0
        is_farther = 2.0 * LINK_M * math.cos(middle / 2.0) > distance
        low, high = (middle, high) if is_farther else (low, middle)
    return (low + high) / 2.0


MEASURES: dict[str, tuple[Callable[[float], float], float, float]] = {
    "degrees": (lambda distance: math.degrees(planned(distance)), 1e-4, 1e-4),
    "half": (lambda distance: planned(distance) / 2.0, 1e-4, 1e-4),
    "distance": (lambda distance: distance, 1e-4, 1e-4),
    "whole cm": (lambda distance: planned(round(distance, 2)), 0.0, TOLERANCE_RAD),
    "whole mm": (lambda distance: planned(round(distance, 3)), 0.0, TOLERANCE_RAD),
}
"""The wrong values that a program may publish for a distance (m), by name, with relative and absolute tolerances."""
ROUNDED = ("whole cm", "whole mm")


class Heart:
    """The heartbeat, over the whole watch and while plans are being made. Times in s."""

    def __init__(self, recording: Recording) -> None:
        self.recording, self.beats = recording, see.beats(recording, HEARTBEAT)
        self.has_too_few_beats = self.beats.share < LEAST_SHARE
        self.times = self.beats.times
        # the spans in which plans were being made, assuming that each plan took as long as the planner needs
        self.plans = sorted((one.t - PLANNING_S, one.t) for one in recording.topic(PLAN.name).arrivals)

        # the position of the longest silence, if it's too long, and whether a plan was being made for most of that time
        silence = self.beats.silence
        self.long_silence = silence.kind if silence.seconds > LONGEST_SILENCE_S else ""
        shared = [min(silence.end, end) - max(silence.start, begin) for begin, end in self.plans]
        self.silence_is_planning = sum(max(0.0, one) for one in shared) >= 0.7 * silence.seconds

        # the mean intervals, each over several heartbeats in a row; steady if they don't change while plans are being
        # made
        self.means = [(b - a) / AVERAGED for a, b in zip(self.times, self.times[AVERAGED:], strict=False)]
        self.typical_s = statistics.median(self.means or [0.0])
        near = [abs(mean - self.typical_s) < STEADY * self.typical_s for mean in self.means]
        self.is_steady = bool(near) and sum(near) >= 0.9 * len(near)

        # the typical intervals while plans are being made, and in the rest of the time
        intervals = [(b - a, self.is_planning((a + b) / 2)) for a, b in pairwise(self.times)]
        busy, idle = ([s for s, planning in intervals if planning is which] for which in (True, False))
        self.busy_s, self.idle_s = (statistics.median(some or [math.nan]) for some in (busy, idle))
        low, high = TYPICALLY_S
        self.is_slower_while_planning = self.busy_s >= 1.1 * self.idle_s and self.idle_s <= high
        planning = [self.is_planning(at) for at in self.times]
        means = [mean for n, mean in enumerate(self.means) if all(planning[n : n + AVERAGED + 1])]
        slower = statistics.median(means or [self.typical_s]) > high and self.is_slower_while_planning
        self.is_even = low <= self.typical_s <= high and not slower

    def is_planning(self, at: float) -> bool:
        n = bisect_left(self.plans, at, key=lambda span: span[1])
        return any(begin <= at for begin, _ in self.plans[n : n + 1])

    @property
    def beats_during_most_plans(self) -> bool:
        inside = [[begin, *(at for at in self.times if begin < at < end), end] for begin, end in self.plans]
        longest = [max(b - a for a, b in pairwise(times)) for times in inside]
        return sum(one < FAR_TOO_SLOW * 2 * HEARTBEAT.period for one in longest) > len(longest) / 2


class Plan(NamedTuple):
    """A published plan, and the request that it fits. Bends are in rad."""

    bend: float
    found: float  # the bend that the planner finds for the request
    off_by: float  # the plan's distance from `found`, or infinity if the plan fits no request
    of: float  # the distance (m) of the request, or NaN if the plan fits no request
    turn: int  # the request's number among the requests for this distance, from 1
    after: float  # the time (s) from that request to the plan
    apart: float  # the time (s) from the previous plan to this one


class Planning:
    """The plans, in the order of publication, and the requests that they answer."""

    def __init__(self, recording: Recording) -> None:
        self.recording = recording
        # this includes requests that were still due when the program exited
        self.asked = [round(one.value["data"], 4) for one in see.script(recording, REQUESTS)]
        self.made = list[Plan]()
        requests = see.published(recording, REQUESTS)
        sent = [(one.wall, round(one.value["data"], 4)) for one in requests]
        turns, last = Counter[float](), -math.inf
        for arrival in sorted(recording.topic(PLAN.name).arrivals, key=lambda one: one.published):
            bend, at = arrival.value["data"], arrival.published
            fit = (d for wall, d in sent if wall <= at and abs(bend - planned(d)) <= ALIKE_RAD)
            of = next(fit, math.nan)
            turns[of] += 1
            asked_at = [wall for wall, d in sent if d == of] or [wall for wall, _ in sent[:1]] or [0.0]
            after = max(0.0, at - asked_at[min(turns[of], len(asked_at)) - 1])
            off_by = math.inf if math.isnan(of) else abs(bend - planned(of))
            self.made.append(Plan(bend, planned(of), off_by, of, turns[of], after, at - last))
            last = at

        # the distances (m) of the plans, and the distances planned more often or less often than requested
        self.order = [plan.of for plan in self.made]
        relay = see.Relay(self.asked, self.order)
        self.missing, often = relay.missing, dict(relay.repeated)
        self.twice = [distance for distance in dict.fromkeys(self.asked) if distance in often]
        # the distances that are requested twice, beginning with the one that's requested twice in a row
        self.repeated = [d for d, times in Counter(self.asked).items() if times > 1]
        # whether only the first requests are answered, in order, and whether only the last request isn't answered
        count = len(self.made)
        self.stops = relay.stops and count > 1
        self.lacks_the_last = self.stops and count == len(self.asked) - 1
        self.strange = next((plan for plan in self.made if math.isnan(plan.of)), None)  # fits no request
        self.soon = [plan for plan in self.made if plan.after < SOONEST_S]
        self.guesses = [plan for plan in self.soon if plan.off_by > SEARCHING_RAD]
        self.off = [plan for plan in self.made if TOLERANCE_RAD < plan.off_by < math.inf]  # nearly right
        self.exact = [one for one in self.off if abs(one.bend - bend_for(one.of)) < TOLERANCE_RAD / 2.0]
        # the typical time (s) between plans, or 0 if there are too few plans
        self.apart_s = statistics.median([plan.apart for plan in self.made[1:]] if count > 2 else [0.0])
        # whether plans come in order but far apart, until the watch ends
        rest_s = WATCH_S + sum(one.wall - one.t for one in requests[:1]) - last
        self.is_too_slow = self.stops and self.apart_s > 1.25 * PLANNING_S and rest_s <= 2.0 * self.apart_s
        # the first plan that followed the previous one sooner than a search takes, if no plan came too soon after its
        # request
        self.close = next((one for one in self.made[1:] if one.apart < SOONEST_S and not self.soon), None)

    @cached_property
    def measure(self) -> str:
        """The name of the wrong value in `MEASURES` that each plan has for some request, or "" if there is none."""
        for name, (measure, rel_tol, abs_tol) in MEASURES.items():
            near = partial(math.isclose, rel_tol=rel_tol, abs_tol=abs_tol)
            right = [measure(distance) for distance in self.asked]
            if all(any(near(plan.bend, one) for one in right) for plan in self.made):
                return name
        return ""

    @property
    def rises_and_falls(self) -> bool:
        """Whether the plans, compared with each other, rise and fall like the requests, or exactly the opposite way."""
        values = (self.asked, [plan.bend for plan in self.made])
        asked, bends = ([(a > b + 1e-5) - (a < b - 1e-5) for a, b in product(v, v)] for v in values)
        return asked in (bends, [-one for one in bends])


HEART, PLANNING = see.once(Heart), see.once(Planning)
FEW, TYPICALLY = WORDS.seen("heartbeat-share.few", Heart), WORDS.seen("heartbeat-share.typically", Heart)
WHY_FEW = WORDS.rules(
    Heart,
    "heartbeat-share",
    ("few", see.otherwise, see.program_ended),
    ("stops", lambda f: f.long_silence == "after"),
    ("begins-late", lambda f: f.long_silence == "before"),
    ("held-up", lambda f: f.long_silence and not f.silence_is_planning),
    ("nobody-serves-the-timer", lambda f: f.long_silence),
    ("in-groups", lambda f: f.is_slower_while_planning and f.beats.burst > 1),
    ("slower-while-planning", lambda f: f.is_slower_while_planning),
    when=lambda f: f.has_too_few_beats,
    about_time=True,
)
WHY_UNEVEN = WORDS.rules(
    Heart,
    "heartbeat-share",
    ("too-many", lambda f: f.beats.share > MOST_SHARE),
    ("a-little-fast", lambda f: f.typical_s < TYPICALLY_S[0] and f.is_steady),
    ("uneven", lambda f: f.typical_s < TYPICALLY_S[0]),
    ("in-groups", lambda f: f.beats.burst > 1),
    ("slower-while-planning", lambda f: f.is_slower_while_planning),
    when=lambda f: not f.has_too_few_beats,
    about_time=["in-groups", "slower-while-planning"],
)
PACE = ("saw", "expected", "typical_s")
OTHER_PERIOD = WORDS.cause("heartbeat-share.other-period", PACE, about_time=True)
EACH_LATE = WORDS.cause("heartbeat-share.each-late", PACE, about_time=True)
WHY_SILENT = WORDS.rules(
    Heart,
    "heartbeat-gap",
    ("stopped", lambda f: f.long_silence == "after", see.program_ended),
    ("stops", lambda f: f.long_silence == "after"),
    ("begins-late", lambda f: f.long_silence == "before"),
    ("other-plans-do-not", lambda f: f.beats.silence.seconds < PLANNING_S and f.beats_during_most_plans),
    ("held-up", lambda f: not f.silence_is_planning),
    ("during-a-plan", see.otherwise),
    about_time=True,
)
NO_PLAN = WORDS.cause("plans-right.none", Planning)
WHY_WRONG = WORDS.rules(
    Planning,
    "plans-right",
    ("step-by-step", lambda f: len(f.made) > len(f.asked) and len(f.guesses) > 1),
    ("not-yet-found", lambda f: f.made[:1] == f.soon[:1] == [f.strange] and f.measure in ("", *ROUNDED)),
    ("one-in-advance", lambda f: f.order[1:] == f.asked),
    ("one-behind", lambda f: 2 < len(f.made) <= len(f.asked) and f.order[1:] == f.asked[: len(f.made) - 1]),
    ("overwritten", lambda f: f.twice and f.missing and all(one.apart >= SOONEST_S for one in f.made[1:])),
    ("race", lambda f: f.twice and f.missing),
    ("degrees", lambda f: f.strange and f.measure == "degrees"),
    ("half", lambda f: f.strange and f.measure == "half"),
    ("distance", lambda f: f.strange and f.measure == "distance"),
    ("not-finite", lambda f: f.strange and not math.isfinite(f.strange.bend)),
    ("besides", lambda f: f.strange and not f.missing),
    ("fits-no-request", lambda f: f.strange),
    ("planner-left-out", lambda f: any(plan.turn == 1 for plan in f.soon)),
    ("from-memory", lambda f: f.soon and len(f.made) <= len(f.asked)),
    ("distance-rounded", lambda f: f.off and f.measure in ROUNDED),
    ("straight-by-hand", lambda f: {(one.bend, one.of) for one in f.off} == {(0.0, max(f.asked))}),
    ("formula", lambda f: f.off and f.exact == f.off),
    ("inexact", lambda f: f.off),
)
OUT_OF_ORDER = WORDS.rules(
    Planning,
    "all-in-order",
    ("none", lambda f: not f.made, see.program_ended),
    ("some-missing", lambda f: f.missing and not f.strange, see.ended_by_error),
    ("too-slow", lambda f: f.is_too_slow),
    ("no-more", lambda f: f.stops, see.program_ended),
    ("some-missing", lambda f: f.missing and not f.strange, see.program_ended),
    ("not-told-apart", lambda f: f.strange),
    ("with-the-next", lambda f: f.lacks_the_last and f.made[0].after > 1.5 * PLANNING_S),
    ("last-missing", lambda f: f.lacks_the_last),
    ("stops-or-refuses", lambda f: f.stops),
    ("first-missing", lambda f: f.missing == f.asked[:1]),
    ("out-of-reach", lambda f: f.missing == [max(f.asked)]),
    ("asked-before", lambda f: f.missing and f.missing in (f.repeated[:1], f.repeated)),
    ("missing", lambda f: f.missing),
    ("twice", lambda f: f.twice),
    ("other-order", lambda f: f.order != f.asked),
    ("shorter-searches", lambda f: f.close and all(one.apart > ALMOST_S for one in f.made[1:])),
    ("side-by-side", lambda f: f.close),
    about_time=["too-slow", "with-the-next", "last-missing", "stops-or-refuses"],
)


@criterion(points=1, title="/robot/heartbeat carries String", needs=[program_runs])
def heartbeat_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, HEARTBEAT)


@criterion(
    points=2, title="90% to 110% of the heartbeats are published, at even intervals", needs=[heartbeat_topic]
)
@see.needs_messages(HEARTBEAT)
def heartbeat_share(recording: Recording) -> Verdict:
    heart = HEART(recording)
    few = heart.has_too_few_beats
    if heart.is_even and not few and heart.beats.share <= MOST_SHARE:
        return see.passed(FEW(heart)[0])
    known = WHY_FEW.first(heart) or WHY_UNEVEN.first(heart)
    saw, expected = (FEW if few else TYPICALLY)(heart)
    typical_s = heart.beats.typical_s if few else heart.typical_s
    late = OTHER_PERIOD if typical_s >= FAR_TOO_SLOW * HEARTBEAT.period else EACH_LATE
    return known or late.verdict(saw=saw, expected=expected, typical_s=typical_s)


@criterion(
    points=2,
    title="The heartbeat never stops for long, not even while the robot plans",
    needs=[heartbeat_topic],
)
@see.needs_messages(HEARTBEAT)
def heartbeat_gap(recording: Recording) -> Verdict:
    heart = HEART(recording)
    if not heart.long_silence:
        return see.passed(f"the longest silence is {heart.beats.silence.seconds:.2f} s")
    return WHY_SILENT.verdict(heart)


@criterion(
    points=1, title="It subscribes to /robot/plan_request and publishes on /robot/plan", needs=[program_runs]
)
def plan_topic(recording: Recording) -> Verdict:
    return see.all_of(see.listens(recording, topic(REQUESTS, Float32)), see.publishes(recording, PLAN))


@criterion(points=2, title="Each plan is correct, and the planner really computed it", needs=[plan_topic])
def plans_right(recording: Recording) -> Verdict:
    plans, nothing = PLANNING(recording), see.no_message(recording, PLAN)
    if nothing is None:
        right = f"{see.count(len(plans.made), 'plan')}, each exactly as the planner finds it"
        return WHY_WRONG.first(plans) or see.passed(right)
    told = NO_PLAN.verdict(plans)
    if "Error" in nothing.saw:
        return replace(told, cause=nothing.cause, because=nothing.because)
    ended = see.program_ended(recording, told.saw, told.expected)
    return ended or see.asks_for_other_qos(recording, REQUESTS, told.saw, told.expected) or told


@criterion(
    points=1,
    title="There is one plan for every request, in order, and only one search runs at a time",
    needs=[plan_topic],
)
def all_in_order(recording: Recording) -> Verdict:
    plans = PLANNING(recording)
    if plans.strange and len(plans.made) == len(plans.asked) and plans.rises_and_falls:
        return see.passed(f"{len(plans.made)} plans for {len(plans.asked)} requests, in order")
    return OUT_OF_ORDER.first(plans) or see.passed(f"{len(plans.made)} requests answered, in order")


@criterion(points=1, title="The program is still running at the end", needs=[program_runs])
def alive_at_end(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)
