"""How exercise 10 is judged: the heartbeat while plans are asked for, and whether each plan is the right one."""

import math
from dataclasses import dataclass

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, topic, watching

HEARTBEAT = topic("/robot/heartbeat", String, hz=10.0)
PLAN = topic("/robot/plan", Float32)
REQUESTS = "/robot/plan_request"

ASKED = ((0.6, 0.70), (0.9, 0.25), (1.2, 0.55), (3.8, 0.40), (4.4, 0.62))  # when (s), distance (m)
LINK_M = 0.4
PLANNING_S = 0.8
SOONEST_S = 0.6
TOLERANCE_RAD = 2e-3

LEAST_SHARE = 0.90  # 0.95 is asked for; the rest is for a machine that has other things to do
MOST_SHARE = 1.12
LONGEST_SILENCE_S = 0.5

WATCH = watching(wall_seconds=7.5, script=[see.says(REQUESTS, Float32, ASKED)])


def bend_for(distance: float) -> float:
    """The bend of the elbow (rad) that brings the hand to `distance` (m) from the shoulder."""
    return 2.0 * math.acos(distance / (2.0 * LINK_M))


@dataclass(frozen=True)
class Plan:
    """One plan that arrived: its bend (rad), the distance (m) that it belongs to, and how long after the request (s).

    `distance` is None when it belongs to no request.
    """

    bend: float
    distance: float | None
    after: float


def plans(recording: Recording) -> list[Plan]:
    """The plans in the order of their arrival."""
    asked = {round(one.value["data"], 4): one.wall for one in see.said(recording, REQUESTS)}
    found = []
    for arrival in recording.topic(PLAN.name).arrivals:
        bend = arrival.value["data"]
        fits = [
            distance
            for distance in asked
            if isinstance(bend, float) and abs(bend - bend_for(distance)) <= TOLERANCE_RAD
        ]
        distance = fits[0] if fits else None
        after = math.inf if distance is None else arrival.published - asked[distance]
        found.append(Plan(bend, distance, after))
    return found


def metres(distances: list[float]) -> str:
    """Distances as one says them."""
    words = [f"{distance:g}" for distance in distances]
    return (", ".join(words[:-1]) + " and " if words[:-1] else "") + f"{words[-1]} m"


@criterion(points=0, title="Your program runs and its node is on the graph")
def program_runs(recording: Recording) -> Verdict:
    return see.program_runs(recording)


@criterion(points=1, title="/robot/heartbeat carries String", needs=[program_runs])
def heartbeat_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, HEARTBEAT)


@criterion(points=2, title="At least 95 % of the heartbeats come", needs=[heartbeat_topic])
def heartbeat_share(recording: Recording) -> Verdict:
    nothing = see.no_message(recording, HEARTBEAT)
    if nothing is not None:
        return nothing
    seen = see.topic_pace(recording, HEARTBEAT)
    start, end = recording.topic(HEARTBEAT.name).window or (0.0, recording.robot_s)
    due = round((end - start) * 10.0)
    share = seen.count / max(1, due)
    saw = f"{seen.count} heartbeats of {due} that were due ({share:.0%})"
    expected = "at least 95 %, at 10 Hz (a few more may be missing, since the machine has other work, too)"
    if share > MOST_SHARE:
        return see.failed(
            saw,
            "10 heartbeats a second, no more",
            "The heart beats from two places, or its period is shorter than 0.1 s. Whoever counts beats to learn "
            "whether the robot is well is misled.",
            "Let one timer of 0.1 s publish the heartbeat, and nothing else.",
        )
    typical = seen.typical_interval or 0.0
    if typical < 0.085 and share >= LEAST_SHARE:
        return see.failed(
            f"typically {typical:.3f} s from one heartbeat to the next",
            "a beat every 0.1 s, evenly",
            "More beats in good times do not make up for those that are missing in bad ones. Who listens wants to know "
            "whether the robot is well now.",
            "Leave the period at 0.1 s, and give the planning a place where it does not stop the heart.",
        )
    if share >= LEAST_SHARE:
        return see.passed(saw)
    if seen.gap.seconds > LONGEST_SILENCE_S:
        return see.failed(
            saw,
            expected,
            "While a plan is made, nobody serves the timer. The planner has the only thread, or it is in the same "
            "callback group as the heartbeat, and of a group only one callback runs at a time.",
            "Give the planning a place of its own: a callback group and a second thread, or a queue and a worker.",
            about_time=True,
        )
    return see.failed(
        saw,
        expected,
        f"No long silence, but every beat comes late: typically {typical:.3f} s after the one before. A loop that "
        "sleeps for the period takes the time of its work on top.",
        "Let create_timer(0.1, ...) make the rhythm: it keeps a plan.",
        about_time=True,
    )


@criterion(
    points=2, title="The heart is never silent for long, not even during a plan", needs=[heartbeat_topic]
)
def heartbeat_gap(recording: Recording) -> Verdict:
    nothing = see.no_message(recording, HEARTBEAT)
    if nothing is not None:
        return nothing
    gap = see.topic_pace(recording, HEARTBEAT).gap
    expected = f"never more than {LONGEST_SILENCE_S} s without a heartbeat"
    if gap.seconds <= LONGEST_SILENCE_S:
        return see.passed(f"the longest silence is {gap.seconds:.2f} s")
    where = f"a silence of {gap.seconds:.2f} s, from {gap.start:.1f} s on"
    if gap.kind == "after":
        return see.failed(
            f"no heartbeat after {gap.start:.1f} s",
            expected,
            "The heart has stopped for good: an exception ended its thread, the node has lost its executor, or the "
            "program has ended.",
            "Look into the log: what was the last thing that happened?",
            about_time=True,
        )
    if gap.seconds < 0.8 * PLANNING_S:
        return see.failed(
            where,
            expected,
            "Something holds up the timer of the heartbeat for more than a few beats.",
            "Let the timer be served by a thread that does nothing long.",
            about_time=True,
        )
    return see.failed(
        where,
        expected,
        f"That is the time of a plan ({PLANNING_S} s): the heart stops while the arm is planned. More threads alone do "
        "not help, nor does a group of its own alone.",
        "Both together do: callback_group=MutuallyExclusiveCallbackGroup() for the slow callback, and a "
        "MultiThreadedExecutor(num_threads=2).",
        about_time=True,
    )


@criterion(
    points=1, title="It listens to /robot/plan_request and answers on /robot/plan", needs=[program_runs]
)
def plan_topic(recording: Recording) -> Verdict:
    return see.all_of(
        see.listens(recording, topic(REQUESTS, Float32)),
        see.publishes(recording, PLAN),
    )


@criterion(points=2, title="Each plan is right, and has really been worked out", needs=[plan_topic])
def plans_right(recording: Recording) -> Verdict:
    nothing = see.no_message(recording, PLAN)
    if nothing is not None:
        return see.failed(
            f"not one plan for {len(ASKED)} requests",
            "a plan on /robot/plan for each request",
            nothing.because
            if "Error" in nothing.saw
            else "The work was handed over and has never been done, or it has failed in silence: an exception in a "
            "pool stays in the future that nobody looks at.",
            "Wrap the work in try/except and log the error, or call result() on the future in a done callback.",
        )
    made = plans(recording)
    expected = "for each request the bend that ElbowPlanner finds for it, once"
    times = [plan.distance for plan in made]
    first = recording.topic(PLAN.name).arrivals[0].published - see.said(recording, REQUESTS)[0].wall
    if first < SOONEST_S:
        return see.failed(
            f"a plan {max(0.0, first):.2f} s after the first request",
            f"a search of {PLANNING_S} s by ElbowPlanner, as it was given",
            "What is published was not yet found: the search has been handed over, and its result is read at once."
            if made[0].distance is None
            else "The planner was changed or left out. On the robot its time goes into asking the collision checker, "
            "and a plan that was not checked may break something.",
            "Publish a plan where it is finished, not what a shared variable happens to hold."
            if made[0].distance is None
            else "Leave ElbowPlanner as it is, and find it another place to work.",
        )
    twice = sorted({one for one in times if one is not None and times.count(one) > 1})
    missing = [distance for _, distance in ASKED if distance not in times]
    strange = next((plan for plan in made if plan.distance is None), None)
    if twice and missing:
        return see.failed(
            f"the plan for {metres(twice)} came more than once, and none for {metres(missing)}",
            expected,
            "Two searches ran at once on one planner, which can remember only one: the second overwrote the first. "
            "That is a race.",
            "Let one search come to its end before the next begins: a mutually exclusive group, one worker, or a lock.",
        )
    if strange is not None:
        return see.failed(
            f"a bend of {strange.bend:.4f} rad, which fits none of the requests",
            expected,
            "The planner was interrupted by another search, stopped before its last step, or asked for its result too "
            "early.",
            "Take all steps of one search (plan() does), then publish what it returned.",
        )
    if twice:
        return see.failed(
            f"the plan for {metres(twice)} came more than once",
            expected,
            "The result is published in two places, or a request is planned twice.",
            "Publish a plan once, where it is finished.",
        )
    return see.passed(f"{len(made)} plans, each the right one")


@criterion(points=1, title="Every request is answered, in the order of the requests", needs=[plans_right])
def all_in_order(recording: Recording) -> Verdict:
    order = [plan.distance for plan in plans(recording)]
    asked = [distance for _, distance in ASKED]
    missing = [distance for distance in asked if distance not in order]
    if missing:
        return see.failed(
            f"no plan for {metres(missing)}",
            f"{len(asked)} plans for {len(asked)} requests",
            "Requests that came while a plan was being made are lost: refused, overwritten by newer ones, or pushed "
            "out of a queue that is too short.",
            "Keep what cannot be done at once: a queue.Queue, or the subscription's own queue with a depth of 10.",
            about_time=True,
        )
    if order != asked:
        return see.failed(
            f"plans for {metres([one for one in order if one is not None])}, in this order",
            f"the order of the requests: {metres(asked)}",
            "The newest request is taken first, or several searches overtake each other.",
            "First in, first out: queue.Queue does that, and so does a mutually exclusive group.",
        )
    return see.passed(f"{len(order)} requests answered, in order")


@criterion(points=1, title="The program is still alive at the end", needs=[program_runs])
def alive_at_end(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)
