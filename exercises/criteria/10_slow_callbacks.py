"""How exercise 10 is judged: the heartbeat while plans are asked for, and whether each plan is the planner's own."""

import math
import random
import statistics
import struct
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import accumulate, pairwise, product

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, program_runs, topic, watching

HEARTBEAT = topic("/robot/heartbeat", String, hz=10.0)
PLAN = topic("/robot/plan", Float32)
REQUESTS = "/robot/plan_request"

FROM_THE_NOTEBOOK_M = 0.7  # one of the distances that the notebook requests
LINK_M = 0.4
PLANNING_S = 0.8
SOONEST_S = 0.78
ALMOST_S = 0.7  # searches side by side end as far apart as their requests, or nearly at once
TOLERANCE_RAD = 1e-6
SEARCHING_RAD = 1e-4  # farther off than the formula, nearer than a search half way
ALIKE_RAD = 0.06  # near enough to tell which request a plan is for

LEAST_SHARE = 0.90
MOST_SHARE = 1.10
TYPICALLY_S = (0.095, 0.105)
STEADY = 0.05  # of the typical interval
FAR_TOO_SLOW = 1.5  # times the period: no work that comes on top takes as long
AVERAGED = 5
"""Beats over which the typical interval is taken: one step of a search may hold up each a little."""
LONGEST_SILENCE_S = 0.5

WATCH_S = 9.0


def drawn(rng: random.Random) -> list[see.Part]:
    """Draw seven requests: three, and four more when the planner is idle again. Until the first, the heart beats alone.

    Of those that wait, the farther one is first here and last there, two are the same, and one cannot be reached. A
    very near one comes twice in a row, for the second time to an idle planner.
    """
    out_of_reach = rng.randint(85, 92) / 100
    very_near = drawn_distance(rng, 0.04, 0.09)
    while True:
        once, again = drawn_distance(rng, 0.2, 0.62), drawn_distance(rng, 0.2, 0.62)
        if told_apart((very_near, once, again, FROM_THE_NOTEBOOK_M)):
            break
    first = [once, FROM_THE_NOTEBOOK_M]
    rng.shuffle(first)
    distances = [*first, very_near, very_near, again, out_of_reach, again]
    begins = [*accumulate([rng.uniform(0.75, 0.9), rng.uniform(0.15, 0.25), rng.uniform(0.15, 0.25)])]
    begins += accumulate([rng.uniform(3.55, 3.68), *(rng.uniform(0.08, 0.1) for _ in range(3))])
    return [see.publish(REQUESTS, Float32, list(zip(begins, distances, strict=True)))]


def drawn_distance(rng: random.Random, least: float, most: float) -> float:
    """Draw a distance (m) whose plan is neither that of the formula nor that for whole millimeters.

    Sent as a float of 32 bits it has the same plan.
    """
    while True:
        distance = round(rng.uniform(least, most), 4)
        [sent] = struct.unpack("f", struct.pack("f", distance))
        plan, others = planned(distance), (bend_for(distance), planned(round(distance, 3)))
        if planned(sent) == plan and all(abs(plan - one) > 1.15 * TOLERANCE_RAD for one in others):
            return distance


def told_apart(distances: Sequence[float]) -> bool:
    """Check that no plan for one of the distances (m), nor half of it, looks like the plan for another one."""
    bends = [planned(distance) for distance in distances]
    return all(
        one is other or abs(one - other) > 2.5 * ALIKE_RAD for one, other in product(bends, bends)
    ) and all(abs(one / 2.0 - other) > 1.5 * ALIKE_RAD for one, other in product(bends, bends))


WATCH = watching(wall_seconds=WATCH_S, script=drawn)


@criterion(points=1, title="/robot/heartbeat carries String", needs=[program_runs])
def heartbeat_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, HEARTBEAT)


@criterion(
    points=2,
    title=f"{LEAST_SHARE:.0%} to {MOST_SHARE:.0%} of the heartbeats come, evenly",
    needs=[heartbeat_topic],
)
@see.needs_messages(HEARTBEAT)
def heartbeat_share(recording: Recording) -> Verdict:
    beats = see.beats(recording, HEARTBEAT)
    saw = f"{beats.count} of {beats.due} heartbeats ({beats.share:.0%})"
    if beats.share > MOST_SHARE:
        return see.failed(
            "heartbeat-share.too-many",
            saw,
            "10 heartbeats a second, no more",
            "Two places publish the heartbeat, or its period is shorter than 0.1 s. A safety system that counts "
            "heartbeats is misled.",
            "Publish the heartbeat only from one 0.1 s timer.",
        )
    if beats.share < LEAST_SHARE:
        ended = see.program_ended(recording, saw, f"at least {LEAST_SHARE:.0%}, at 10 Hz")
        return ended or why_beats_are_missing(recording, beats, saw)
    return uneven(recording) or see.passed(saw)


@criterion(
    points=2,
    title="The heartbeat never stops for long, not even while the robot plans",
    needs=[heartbeat_topic],
)
@see.needs_messages(HEARTBEAT)
def heartbeat_gap(recording: Recording) -> Verdict:
    silence = see.beats(recording, HEARTBEAT).silence
    if silence.seconds <= LONGEST_SILENCE_S:
        return see.passed(f"the longest silence is {silence.seconds:.2f} s")
    expected = f"never more than {LONGEST_SILENCE_S} s without a heartbeat"
    if silence.kind == "after":
        saw = f"no heartbeat after {silence.start:.1f} s"
        return see.program_ended(recording, saw, expected) or see.failed(
            "heartbeat-gap.stops",
            saw,
            expected,
            "Its callback no longer publishes, an exception ended its thread, or the node lost its executor.",
            "Read the log: what was the last thing that happened?",
            about_time=True,
        )
    where = f"a silence of {silence.seconds:.2f} s, from {silence.start:.1f} s on"
    if silence.kind == "before":
        where = f"no heartbeat until {silence.end:.2f} s"
        return begins_late("heartbeat-gap.begins-late", where, expected)
    if silence.seconds < PLANNING_S and beats_during_most_plans(recording):
        return held_up_once(where, expected)
    if not during_plans(recording, silence.start, silence.end):
        return see.failed(
            "heartbeat-gap.held-up",
            where,
            expected,
            "Planning doesn't explain all of that silence. Something else delays the heartbeat.",
            "Run the heartbeat's timer in a thread that does no slow work.",
            about_time=True,
        )
    return see.failed(
        "heartbeat-gap.during-a-plan",
        where,
        expected,
        f"The heartbeat stops while a plan is computed ({PLANNING_S} s for each plan). More threads alone do not "
        "help, and neither does a separate callback group alone.",
        "You need both: callback_group=MutuallyExclusiveCallbackGroup() for the slow callback, and a "
        "MultiThreadedExecutor(num_threads=2).",
        about_time=True,
    )


def in_groups(recording: Recording) -> Verdict | None:
    """A failed verdict when several heartbeats come at one moment, and then none for a while; None otherwise."""
    pace = see.topic_pace(recording, HEARTBEAT)
    if not pace.in_bursts:
        return None
    return see.failed(
        "heartbeat-share.in-groups",
        f"{pace.count} heartbeats, {pace.burst} at a time",
        "one heartbeat every 0.1 s",
        "Several heartbeats are published at the same time, and then none for a while. One callback publishes them "
        "all, or makes up for missing ones.",
        "Publish one heartbeat on every tick of a 0.1 s timer.",
        about_time=True,
    )


def begins_late(cause: str, saw: str, expected: str) -> Verdict:
    """The first heartbeat comes late."""
    return see.failed(
        cause,
        saw,
        expected,
        "The heartbeat starts late: its timer is created only after something else has happened, or its callback "
        "doesn't publish at first.",
        "Create the heartbeat's timer in __init__, and publish on every tick.",
        about_time=True,
    )


def held_up_once(where: str, expected: str) -> Verdict:
    """The heartbeat stops for less than a plan, and goes on during most plans."""
    return see.failed(
        "heartbeat-gap.other-plans-do-not",
        f"{where}; during most plans, the heartbeat continues",
        expected,
        "Planning doesn't delay the heartbeat: it continues during other plans, and the silence is shorter than a "
        "plan. Something else delays it, such as a callback that's sometimes slow.",
        "Read the log: what did the program do at that time? Run the heartbeat's timer in a thread that does no "
        "slow work.",
        about_time=True,
    )


@criterion(
    points=1, title="It subscribes to /robot/plan_request and publishes on /robot/plan", needs=[program_runs]
)
def plan_topic(recording: Recording) -> Verdict:
    return see.all_of(
        see.listens(recording, topic(REQUESTS, Float32)),
        see.publishes(recording, PLAN),
    )


@criterion(points=2, title="Each plan is correct, and the planner really computed it", needs=[plan_topic])
def plans_right(recording: Recording) -> Verdict:
    nothing = see.no_message(recording, PLAN)
    if nothing is not None:
        return no_plan(recording, nothing)
    made, asked = plans(recording), requests(recording)
    return (
        not_yet_found(made, asked)
        or not_its_own(made, asked)
        or fits_no_request(made, asked)
        or too_soon(made, asked)
        or inexact(made, asked)
        or see.passed(f"{see.count(len(made), 'plan')}, each exactly as the planner finds it")
    )


@criterion(
    points=1,
    title="There is one plan for every request, in the order of the requests, one search at a time",
    needs=[plan_topic],
)
def all_in_order(recording: Recording) -> Verdict:
    made, asked = plans(recording), requests(recording)
    expected = f"{len(asked)} plans for {len(asked)} requests"
    if not made:
        return see.program_ended(recording, "no plan at all", expected) or see.failed(
            "all-in-order.none",
            "no plan at all",
            expected,
            "Nothing was published, so no request has been answered.",
            "Start with one request: does its plan arrive?",
        )
    if any(plan.of is None for plan in made):
        return not_told_apart(made, asked, expected)
    return (
        missing_or_twice(recording, made, asked, expected)
        or other_order(made, asked)
        or side_by_side(made)
        or see.passed(f"{len(made)} requests answered, in order")
    )


@criterion(points=1, title="The program is still alive at the end", needs=[program_runs])
def alive_at_end(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)


# --- the heartbeat ------------------------------------------------------------------------------------------


def intervals(recording: Recording, averaged: int) -> list[float]:
    """Mean intervals (s), each over so many beats in a row."""
    times = [arrival.t for arrival in recording.topic(HEARTBEAT.name).arrivals]
    return [(end - start) / averaged for start, end in zip(times, times[averaged:], strict=False)]


def while_planning(recording: Recording) -> list[float]:
    """The mean intervals (s) of those beats in a row that all came while plans were made."""
    times = [arrival.t for arrival in recording.topic(HEARTBEAT.name).arrivals]
    spans = planning_spans(recording)
    busy = [any(begin <= at <= end for begin, end in spans) for at in times]
    means = intervals(recording, AVERAGED)
    return [mean for n, mean in enumerate(means) if all(busy[n : n + AVERAGED + 1])]


def planning_spans(recording: Recording) -> list[tuple[float, float]]:
    """The spans (s) in which plans were being made, if each took the planner's time."""
    return [(arrival.t - PLANNING_S, arrival.t) for arrival in recording.topic(PLAN.name).arrivals]


def during_plans(recording: Recording, start: float, end: float) -> bool:
    """Whether a plan was being made for most of a span (s)."""
    shared = [min(end, b) - max(start, a) for a, b in planning_spans(recording)]
    return sum(max(0.0, one) for one in shared) >= 0.7 * (end - start)


def beats_during_most_plans(recording: Recording) -> bool:
    """Whether the heart beat in more than half of the times in which plans were made, and never stopped for long."""
    times = [arrival.t for arrival in recording.topic(HEARTBEAT.name).arrivals]
    spans = planning_spans(recording)
    steady_ones = 0
    for begin, end in spans:
        inside = [begin, *(at for at in times if begin < at < end), end]
        steady_ones += max(b - a for a, b in pairwise(inside)) < FAR_TOO_SLOW * 2 * HEARTBEAT.period
    return steady_ones > len(spans) / 2


def typically_s(recording: Recording, *, planning: bool) -> float | None:
    """The typical interval (s) of beats while plans are made, or in the rest of the time; None without any."""
    times = [arrival.t for arrival in recording.topic(HEARTBEAT.name).arrivals]
    spans = planning_spans(recording)
    found = [b - a for a, b in pairwise(times) if any(s <= (a + b) / 2 <= e for s, e in spans) is planning]
    return statistics.median(found) if found else None


def uneven(recording: Recording) -> Verdict | None:
    """Enough beats come, and typically sooner or later than they should."""
    means = intervals(recording, AVERAGED)
    low, high = TYPICALLY_S
    typical = statistics.median(means) if means else 0.0
    expected = f"typically {low} to {high} s"
    if low <= typical <= high:
        meanwhile = statistics.median(while_planning(recording) or means or [typical])
        return slower_while_planning(recording, expected) if meanwhile > high else None
    saw = f"typically {typical:.3f} s from one heartbeat to the next (the mean of {AVERAGED})"
    if typical < low and means and steady(means):
        return see.failed(
            "heartbeat-share.a-little-fast",
            saw,
            expected,
            "The heartbeat is steady but a little too fast: its period is shorter than 0.1 s.",
            "10 Hz is a period of 0.1 s: create_timer(0.1, ...).",
        )
    if typical < low:
        return see.failed(
            "heartbeat-share.uneven",
            saw,
            expected,
            "Extra heartbeats at one time do not make up for missing ones at another. The safety system needs to "
            "know whether the robot is well now.",
            "Set the period to 0.1 s, and move the planning out of the heartbeat's way, to another thread and "
            "callback group.",
        )
    if together := in_groups(recording):
        return together
    return slower_while_planning(recording, expected) or each_late(saw, expected, typical)


def steady(means: Sequence[float]) -> bool:
    """Whether nine in ten of these means (s) are about the same: with and without a plan being made."""
    typical = statistics.median(means)
    return sum(abs(one - typical) < STEADY * typical for one in means) >= 0.9 * len(means)


def slower_while_planning(recording: Recording, expected: str) -> Verdict | None:
    """While plans are made the heart beats more slowly than in the rest of the time."""
    busy, idle = typically_s(recording, planning=True), typically_s(recording, planning=False)
    if busy is None or idle is None or busy < 1.1 * idle or idle > TYPICALLY_S[1]:
        return None
    if together := in_groups(recording):
        return together
    return see.failed(
        "heartbeat-share.slower-while-planning",
        f"typically {busy:.2f} s from one heartbeat to the next while a plan is made, {idle:.2f} s otherwise",
        expected,
        "While a plan is being computed, the planning determines when heartbeats are published, or some are "
        "skipped.",
        "Publish every heartbeat from one 0.1 s timer, whether or not a plan is being computed.",
        about_time=True,
    )


def each_late(saw: str, expected: str, typical: float) -> Verdict:
    """No long silence, and every interval is too long."""
    if typical >= FAR_TOO_SLOW * HEARTBEAT.period:
        return see.failed(
            "heartbeat-share.other-period",
            f"{saw}; one every {typical:.2g} s",
            expected,
            "The heartbeat is steady but too slow: its period is longer than 0.1 s.",
            "10 Hz is a period of 0.1 s: create_timer(0.1, ...).",
            about_time=True,
        )
    return see.failed(
        "heartbeat-share.each-late",
        saw,
        expected,
        f"There's no long silence, but the heartbeats are typically {typical:.3f} s apart. The period is longer "
        "than 0.1 s, or a loop sleeps for a full period in addition to its work.",
        "Use create_timer(0.1, ...): a timer compensates for the time that the work takes.",
        about_time=True,
    )


def why_beats_are_missing(recording: Recording, beats: see.Beats, saw: str) -> Verdict:
    """In one long silence, only while plans are made, or each a little late."""
    expected = f"at least {LEAST_SHARE:.0%}, at 10 Hz"
    if beats.silence.seconds <= LONGEST_SILENCE_S:
        return slower_while_planning(recording, expected) or each_late(saw, expected, beats.typical_s)
    if beats.silence.kind == "after":
        saw = f"{saw}; none after {beats.silence.start:.1f} s"
        return see.program_ended(recording, saw, expected) or see.failed(
            "heartbeat-share.stops",
            saw,
            expected,
            "The heartbeat has stopped: its callback no longer publishes, or its timer or thread has ended.",
            "Read the log: what was the last thing that happened?",
            about_time=True,
        )
    if beats.silence.kind == "before":
        saw = f"{saw}; none until {beats.silence.end:.1f} s"
        return begins_late("heartbeat-share.begins-late", saw, expected)
    if not during_plans(recording, beats.silence.start, beats.silence.end):
        return see.failed(
            "heartbeat-share.held-up",
            f"{saw}; none for {beats.silence.seconds:.1f} s from {beats.silence.start:.1f} s on",
            expected,
            "Planning doesn't explain all of that silence. Something else delays the heartbeat.",
            "Run the heartbeat's timer in a thread that does no slow work.",
            about_time=True,
        )
    return see.failed(
        "heartbeat-share.nobody-serves-the-timer",
        saw,
        expected,
        "Heartbeats are missing while plans are computed. Usually, the planner occupies the only thread. Or it's "
        "in the heartbeat's callback group, which runs only one callback at a time. Or several plans occupy all "
        "threads at the same time.",
        "Separate the planning from the heartbeat: use a second callback group and a second thread, or a queue and "
        "a worker thread.",
        about_time=True,
    )


# --- the plans ----------------------------------------------------------------------------------------------


def bend_for(distance: float) -> float:
    """The bend of the elbow (rad) that brings the hand to `distance` (m) from the shoulder, by the formula."""
    return 2.0 * math.acos(min(1.0, distance / (2.0 * LINK_M)))


@lru_cache
def planned(distance: float) -> float:
    """The bend (rad) that ElbowPlanner finds for `distance` (m): after its twenty steps, no nearer."""
    low, high = 0.0, math.pi
    for _ in range(20):
        middle = (low + high) / 2.0
        if 2.0 * LINK_M * math.cos(middle / 2.0) > distance:
            low = middle
        else:
            high = middle
    return (low + high) / 2.0


@dataclass(frozen=True)
class Plan:
    """A plan as it was published: the bend (rad), the distance (m) of the request that it fits (None: of none), which
    request of this distance it is (1: the first), how long after that request it came and after the plan before (s).
    """

    bend: float
    of: float | None
    turn: int
    after: float
    apart: float

    @property
    def name(self) -> str:
        return "" if self.of is None else metres([self.of])


def requests(recording: Recording) -> list[float]:
    """List the distances (m) that the judge asks for, also those that were to come when the program ended."""
    return [round(one.value["data"], 4) for one in see.script(recording, REQUESTS)]


@see.once
def plans(recording: Recording) -> list[Plan]:
    """The plans, in the order in which they were published."""
    said = [(one.wall, round(one.value["data"], 4)) for one in see.published(recording, REQUESTS)]
    arrivals = sorted(recording.topic(PLAN.name).arrivals, key=lambda one: one.published)
    made: list[Plan] = []
    turns: Counter[float | None] = Counter()
    last = -math.inf
    for arrival in arrivals:
        bend, at = arrival.value["data"], arrival.published
        of = next((d for wall, d in said if wall <= at and abs(bend - planned(d)) <= ALIKE_RAD), None)
        moments = [wall for wall, d in said if d == of]
        turns[of] += 1
        after = (
            at - moments[min(turns[of], len(moments)) - 1] if moments else at - (said[0][0] if said else 0.0)
        )
        made.append(Plan(bend, of, turns[of], after, at - last))
        last = at
    return made


def off_by(plan: Plan) -> float:
    """How far (rad) a plan is from what the planner finds; infinite if it fits no request."""
    return math.inf if plan.of is None else abs(plan.bend - planned(plan.of))


def metres(distances: Sequence[float]) -> str:
    """Distances as one says them."""
    return f"{see.listing([f'{distance:g}' for distance in distances])} m"


def too_many_and_missing(made: Sequence[Plan], asked: Sequence[float]) -> tuple[list[float], list[float]]:
    """Distances (m) that were planned more often than they were requested, and less often."""
    times, wanted = Counter(plan.of for plan in made), Counter(asked)
    every = list(dict.fromkeys(asked))
    return [d for d in every if times[d] > wanted[d]], [d for d in every if times[d] < wanted[d]]


EACH_RIGHT = "for each request the bend that ElbowPlanner finds for it"


def no_plan(recording: Recording, nothing: Verdict) -> Verdict:
    """Not one plan arrived, for the reason of `nothing` where an error is to blame."""
    saw, expected = (
        f"no plan for {len(requests(recording))} requests",
        "a plan on /robot/plan for each request",
    )
    try_this = (
        "Wrap the work in try/except and log the error, or call result() on the future in a done callback."
    )
    if "Error" in nothing.saw:
        return see.failed(nothing.cause, saw, expected, nothing.because, try_this)
    ended = see.program_ended(recording, saw, expected)
    return (
        ended
        or see.asks_for_other_qos(recording, REQUESTS, saw, expected)
        or see.failed(
            "plans-right.none",
            saw,
            expected,
            "The work was handed over but never done, or it failed silently. An exception in a thread pool stays "
            "in its future until your code calls result().",
            try_this,
        )
    )


def not_yet_found(made: Sequence[Plan], asked: Sequence[float]) -> Verdict | None:
    """The first plan came before it can have been found, and is not the one that was asked for."""
    first = made[0]
    early = [plan for plan in made if plan.after < SOONEST_S and off_by(plan) > SEARCHING_RAD]
    if len(made) > len(asked) and len(early) > 1:
        return see.failed(
            "plans-right.step-by-step",
            f"a bend of {early[0].bend:.4f} rad {early[0].after:.2f} s after the request, and {len(made)} plans in all",
            EACH_RIGHT,
            "The bend found so far is published while the planner is still searching.",
            "Publish one plan per request: the value that plan() returns.",
        )
    if first.of is not None or first.after >= SOONEST_S or told_by_another_measure(made, asked) is not None:
        return None
    return see.failed(
        "plans-right.not-yet-found",
        f"a bend of {first.bend:.4f} rad {max(0.0, first.after):.2f} s after the first request",
        f"the result of a {PLANNING_S} s search by the unchanged ElbowPlanner",
        "The result was published before it was found: the search was handed to another thread, but its result was "
        "read right away.",
        "Publish a plan where the search finishes, not the current value of a shared variable.",
    )


def not_its_own(made: Sequence[Plan], asked: Sequence[float]) -> Verdict | None:
    """Requests got the plans of others: of the one before, or of one that overtook them on the same planner."""
    order = [plan.of for plan in made]
    if order[1:] == asked:
        return see.failed(
            "plans-right.one-in-advance",
            f"a bend of {made[0].bend:.4f} rad, then the plans for all {len(asked)} requests",
            EACH_RIGHT,
            "A value was published before the plan for the first request, for example an initial value.",
            "Publish one plan per request: the value that plan() returns.",
        )
    if 2 < len(order) <= len(asked) and order[1:] == asked[: len(order) - 1] and order != asked[: len(order)]:
        return see.failed(
            "plans-right.one-behind",
            f"the second plan is the one for the first request ({metres(asked[:1])}), and so on",
            EACH_RIGHT,
            "The published value is the result of the previous search.",
            "Publish the value that plan() has just returned.",
        )
    twice, missing = too_many_and_missing(made, asked)
    return why_mixed_up(made, twice, missing) if twice and missing else None


def why_mixed_up(made: Sequence[Plan], twice: list[float], missing: list[float]) -> Verdict:
    """Why some requests got two plans, and others none."""
    if all(plan.apart >= SOONEST_S for plan in made[1:]):
        return see.failed(
            "plans-right.overwritten",
            f"too many plans for {metres(twice)}, too few for {metres(missing)}",
            EACH_RIGHT,
            "A later request overwrote an earlier one: all waiting requests share one variable for their distance, "
            "or begin() was called while the planner was searching.",
            "Keep each waiting distance, for example in a queue.Queue, and begin a search when the previous one is "
            "done.",
        )
    return see.failed(
        "plans-right.race",
        f"too many plans for {metres(twice)}, too few for {metres(missing)}",
        EACH_RIGHT,
        "Two searches ran at the same time on one planner, which can hold only one: the second overwrote the "
        "first. That's a race condition.",
        "Let one search finish before the next begins: use a mutually exclusive group, one worker thread, or a "
        "lock.",
    )


OTHER_MEASURES: dict[str, Callable[[float], float]] = {
    "degrees": lambda distance: math.degrees(planned(distance)),
    "half": lambda distance: planned(distance) / 2.0,
    "distance": lambda distance: distance,
}


def told_by_another_measure(made: Sequence[Plan], asked: Sequence[float]) -> str | None:
    """In which other measure all plans are right: "degrees", "half" of the angle, the "distance"; None in none."""
    for name, measured in OTHER_MEASURES.items():
        said = [measured(distance) for distance in asked]
        if all(
            any(math.isclose(plan.bend, one, rel_tol=1e-4, abs_tol=1e-4) for one in said) for plan in made
        ):
            return name
    return None


def fits_no_request(made: Sequence[Plan], asked: Sequence[float]) -> Verdict | None:
    """A bend belongs to no request."""
    strange = next((plan for plan in made if plan.of is None), None)
    if strange is None:
        return None
    saw = f"a bend of {strange.bend:.4f} rad, which fits none of the requests"
    return (
        in_another_measure(told_by_another_measure(made, asked), saw)
        or of_its_own(made, asked, strange, saw)
        or see.failed(
            "plans-right.fits-no-request",
            saw,
            EACH_RIGHT,
            "The planner received something other than the requested distance, was interrupted by another search, "
            "or was stopped long before its last step.",
            "Pass the request's data to the planner, run all steps of one search (plan() does that), and then "
            "publish the result.",
        )
    )


def in_another_measure(measure: str | None, saw: str) -> Verdict | None:
    """All plans are right in another measure."""
    if measure == "degrees":
        return see.failed(
            "plans-right.degrees",
            saw,
            EACH_RIGHT,
            "Each value is the right bend, but in degrees. ROS uses radians.",
            "Publish the value that the planner returns: it's in radians.",
        )
    if measure == "half":
        return see.failed(
            "plans-right.half",
            saw,
            EACH_RIGHT,
            "Each value is half of the right bend.",
            "Publish the value that the planner returns, unchanged.",
        )
    if measure == "distance":
        return see.failed(
            "plans-right.distance",
            saw,
            EACH_RIGHT,
            "That's the distance of a request (m), not a bend.",
            "Publish the bend that the planner returns for this distance.",
        )
    return None


def of_its_own(made: Sequence[Plan], asked: Sequence[float], strange: Plan, saw: str) -> Verdict | None:
    """A value that comes from no search: not a number, or one besides the plans of all requests."""
    if not math.isfinite(strange.bend):
        return see.failed(
            "plans-right.not-finite",
            saw,
            EACH_RIGHT,
            "That isn't an angle. Your program computes or sets this value itself, for example for a distance out "
            "of reach.",
            "Pass every request to the planner, and publish the value that plan() returns.",
        )
    if not too_many_and_missing(made, asked)[1]:
        return see.failed(
            "plans-right.besides",
            f"{saw}; the plans for all {len(asked)} requests also arrived",
            EACH_RIGHT,
            "In addition to the plans, your program publishes a value of its own: at the start, in a pause, or "
            "after a plan.",
            "Publish only the values that plan() returns for requests.",
        )
    return None


def too_soon(made: Sequence[Plan], asked: Sequence[float]) -> Verdict | None:
    """A plan came sooner than it can have been worked out."""
    soon = [plan for plan in made if plan.after < SOONEST_S]
    if not soon:
        return None
    again = all(plan.turn > 1 for plan in soon)
    saw = f"the plan for {soon[0].name} {soon[0].after:.2f} s after its request"
    expected = f"a {PLANNING_S} s search by the unchanged ElbowPlanner"
    if again and len(made) <= len(asked):
        return see.failed(
            "plans-right.from-memory",
            f"{saw}; the same distance had been requested before",
            expected,
            "The first plan was stored and reused. Since then, something may have moved into the arm's way.",
            "Let the planner search for every request, even for a distance that was requested before.",
        )
    if again:
        return None
    return see.failed(
        "plans-right.planner-left-out",
        saw,
        expected,
        "The planner was changed or skipped, or it didn't run all of its steps. On the robot, it spends its time "
        "checking for collisions, and an unchecked plan may break something.",
        "Don't change ElbowPlanner. Let it finish each search, but run it in another thread.",
    )


def inexact(made: Sequence[Plan], asked: Sequence[float]) -> Verdict | None:
    """A plan is near what the planner finds, and not quite that."""
    off = [plan for plan in made if plan.of is not None and abs(plan.bend - planned(plan.of)) > TOLERANCE_RAD]
    if not off:
        return None
    first = off[0]
    assert first.of is not None
    saw = (
        f"a bend of {first.bend:.7f} rad for {first.name}, but the planner finds {planned(first.of):.7f} rad"
    )
    expected = f"{EACH_RIGHT}, to {TOLERANCE_RAD:.6f} rad"
    rounded = rounded_to(made, asked)
    if rounded is not None:
        return see.failed(
            "plans-right.distance-rounded",
            saw,
            expected,
            f"Each plan is correct for its request's distance rounded to {rounded}.",
            "Pass the request's data to the planner unchanged.",
        )
    if all(plan.bend == 0.0 and plan.of == max(asked) for plan in off):
        return see.failed(
            "plans-right.straight-by-hand",
            saw,
            expected,
            "For a distance out of reach, your program publishes 0.0 itself.",
            "Pass every request to the planner, and publish the value that plan() returns.",
        )
    if all(plan.of is not None and abs(plan.bend - bend_for(plan.of)) < TOLERANCE_RAD / 2.0 for plan in off):
        return see.failed(
            "plans-right.formula",
            saw,
            expected,
            "The bend is closer to the exact angle than the planner gets in its twenty steps. So it was computed "
            "by a formula, or with more steps than a search has.",
            "Don't change ElbowPlanner, and publish the value that plan() returns.",
        )
    return cut_short(saw, expected)


def cut_short(saw: str, expected: str) -> Verdict:
    """A plan is less exact than the planner's."""
    return see.failed(
        "plans-right.inexact",
        saw,
        expected,
        "The result was rounded, or the search was stopped before its last step.",
        "Run all steps of one search (plan() does that), and publish the returned value unchanged.",
    )


def rounded_to(made: Sequence[Plan], asked: Sequence[float]) -> str | None:
    """To what all distances were rounded before they were planned: "whole cm" or "whole mm"; None if they were not."""
    for digits, name in ((2, "whole cm"), (3, "whole mm")):
        said = [planned(round(distance, digits)) for distance in asked]
        if all(any(abs(plan.bend - one) <= TOLERANCE_RAD for one in said) for plan in made):
            return name
    return None


# --- in order -----------------------------------------------------------------------------------------------


def not_told_apart(made: Sequence[Plan], asked: Sequence[float], expected: str) -> Verdict:
    """Some plans fit no request. Whether all are answered in order shows in how they go up and down, or not at all."""
    bends = [plan.bend for plan in made]
    if len(made) == len(asked) and ranks(asked) in (ranks(bends), ranks([-one for one in bends])):
        return see.passed(f"{len(made)} plans for {len(asked)} requests, in order")
    return see.failed(
        "all-in-order.not-told-apart",
        f"{see.count(len(made), 'plan')} for {len(asked)} requests; at least one plan fits no request",
        expected,
        "The judge can't tell which request a plan belongs to if it fits none of them.",
        "First, make sure that each plan is correct.",
    )


def ranks(values: Sequence[float]) -> list[int]:
    """For each value, how many different ones are clearly smaller."""
    steps: list[float] = []
    for value in sorted(values):
        if not steps or value - steps[-1] > 1e-5:
            steps.append(value)
    return [sum(step < value - 1e-5 for step in steps) for value in values]


def missing_or_twice(
    recording: Recording, made: Sequence[Plan], asked: Sequence[float], expected: str
) -> Verdict | None:
    """A request was answered more than once, or not at all."""
    twice, missing = too_many_and_missing(made, asked)
    if missing:
        return why_missing(recording, made, missing, expected)
    if twice:
        return see.failed(
            "all-in-order.twice",
            f"{len(made)} plans, more than requested for {metres(twice)}",
            expected,
            "Two places publish the result, it's published again later, or a request is planned twice.",
            "Publish a plan once, where its search finishes.",
        )
    return None


def why_missing(recording: Recording, made: Sequence[Plan], missing: list[float], expected: str) -> Verdict:
    """The program is too slow, nothing came after a while, one kind of request is refused, or requests get lost."""
    order, asked = [plan.of for plan in made], requests(recording)
    saw = f"{see.count(len(made), 'plan')}; one is missing for {metres(missing)}"
    error = see.ended_by_error(recording, saw, expected)
    if error is not None:
        return error
    apart = statistics.median([plan.apart for plan in made[1:]]) if len(made) > 2 else 0.0
    ready = rest_s(recording) > 2.0 * apart
    if order == asked[: len(order)] and apart > 1.25 * PLANNING_S and not ready:
        return see.failed(
            "all-in-order.too-slow",
            f"{len(made)} plans in {WATCH_S:g} s, typically {apart:.1f} s apart",
            f"{expected} within {WATCH_S:g} s; a search takes {PLANNING_S} s",
            "Your program waits between the steps of a search or between searches. Or it searches more than once "
            "for a request.",
            "Begin the next step, or the next search, as soon as the previous one is finished.",
            about_time=True,
        )
    if len(order) > 1 and order == asked[: len(order)]:
        return nothing_more(recording, made, saw, expected)
    ended = see.program_ended(recording, saw, expected)
    return (
        ended
        or refused(asked, missing, saw, expected)
        or see.failed(
            "all-in-order.missing",
            saw,
            expected,
            "Requests that arrive while a plan is being computed are lost: refused, overwritten by newer ones, or "
            "dropped from a queue that's too short.",
            "Keep the requests that must wait in a queue.Queue, or in the subscription's own queue with a depth of "
            "10.",
        )
    )


def rest_s(recording: Recording) -> float:
    """How long (s) the watch went on after the last plan."""
    first = see.published(recording, REQUESTS)[0]
    return first.wall - first.t + WATCH_S - recording.topic(PLAN.name).arrivals[-1].published


def nothing_more(recording: Recording, made: Sequence[Plan], saw: str, expected: str) -> Verdict:
    """The first requests are answered, and the last one or ones are not."""
    saw = f"{saw}. No plan followed after number {len(made)}"
    ended = see.program_ended(recording, saw, expected)
    if ended is not None:
        return ended
    one_missing = len(made) == len(requests(recording)) - 1
    if one_missing and made[0].after > 1.5 * PLANNING_S:
        return see.failed(
            "all-in-order.with-the-next",
            f"{saw}; number 1 had arrived {made[0].after:.1f} s after its request",
            expected,
            "A plan is published only when the next one is finished, so the last one is never published.",
            "Publish each plan as soon as plan() has returned it.",
            about_time=True,
        )
    if one_missing:
        return see.failed(
            "all-in-order.last-missing",
            saw,
            expected,
            "The last request that had to wait is lost: dropped from a queue that's too short, or refused because "
            "the same distance was already waiting. Or the planning has stopped.",
            "Keep each request that must wait, in a queue.Queue or in the subscription's own queue with a depth of "
            "10.",
            about_time=True,
        )
    return see.failed(
        "all-in-order.stops-or-refuses",
        saw,
        expected,
        "The planning has stopped: a loop has ended, an error has ended its thread, or a 'busy' flag was never "
        "reset. Or requests that arrive soon after another one are refused.",
        "Read the log. Let the planning wait for the next request for as long as the program runs.",
        about_time=True,
    )


def refused(asked: Sequence[float], missing: list[float], saw: str, expected: str) -> Verdict | None:
    """Requests of one kind were not answered: those out of reach, or those that were made before."""
    if missing == asked[:1]:
        return see.failed(
            "all-in-order.first-missing",
            saw,
            expected,
            "The first request was not answered, although nothing else was being planned. Your code treats it as a "
            "test or an initial value.",
            "Answer each request, including the first one.",
        )
    if missing == [max(asked)]:
        return see.failed(
            "all-in-order.out-of-reach",
            saw,
            expected,
            f"The arm cannot reach {metres(missing)}, and the request was not answered.",
            "Pass every request to the planner. For a distance out of reach, it returns the bend of the straight "
            "arm.",
        )
    again = [one for one, times in Counter(asked).items() if times > 1]
    if missing in ([one for one, other in pairwise(asked) if one == other], again):
        return see.failed(
            "all-in-order.asked-before",
            saw,
            expected,
            "Your node skips a distance that was requested before. But a repeated distance is still a new request.",
            "Answer each request, no matter what was requested before.",
        )
    return None


def other_order(made: Sequence[Plan], asked: Sequence[float]) -> Verdict | None:
    """All requests are answered, in another order."""
    order = [plan.of for plan in made if plan.of is not None]
    if order == asked:
        return None
    return see.failed(
        "all-in-order.other-order",
        f"plans for {metres(order)}, in this order",
        f"the order of the requests: {metres(asked)}",
        "Waiting requests aren't processed in order (for example, the newest or the nearest first), or several "
        "searches overtake each other.",
        "Process requests first in, first out: queue.Queue does that, and so does a mutually exclusive group.",
    )


def side_by_side(made: Sequence[Plan]) -> Verdict | None:
    """Plans come closer to each other than one search takes, although each took its time."""
    close = next((plan for plan in made[1:] if plan.apart < SOONEST_S), None)
    if close is None or any(plan.after < SOONEST_S for plan in made):
        return None
    if all(plan.apart > ALMOST_S for plan in made[1:]):
        return see.failed(
            "all-in-order.shorter-searches",
            f"the plan for {close.name} {close.apart:.3f} s after the previous plan",
            f"a {PLANNING_S} s search by the unchanged ElbowPlanner",
            "Your searches are a little shorter than the planner's: its steps or their duration were changed.",
            "Don't change ElbowPlanner, but run it in another thread.",
        )
    return see.failed(
        "all-in-order.side-by-side",
        f"the plan for {close.name} {close.apart:.2f} s after the previous plan",
        f"one search at a time, {PLANNING_S} s each",
        "Several searches run at the same time. There's only one collision checker, so requests must wait their "
        "turn.",
        "Let one worker, or one mutually exclusive group, plan for all requests.",
    )
