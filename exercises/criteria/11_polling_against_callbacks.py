"""How exercise 11 is judged: sixty numbered touches, and when each of them is reported."""

import math
import random
import statistics
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from std_msgs.msg import Int32

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, program_runs, topic, watching

TOUCH = "/robot/touch"
SEEN = topic("/monitor/seen", Int32)

IN_A_RUN, IN_A_BUNCH = 8, 11  # touches that come one by one, and in one moment
PAUSE_S = 2.0  # no touch for longer than that is the pause, of three seconds
REPORTED_BY_S = 0.25  # so long after the last touch, a program is at rest

ALONE_MS = (
    10.0  # a callback needs 1 ms, on a busy machine 2 ms; one that looks every 20 ms is late by up to 20
)
ALONE_SHARE = 0.75
TOGETHER_MS = (
    200.0  # half of a bunch: by far more than eleven callbacks need, less than eleven sleeps of 0.05 s
)
MOSTLY = 0.7
AT_ONCE_S = 0.02
TOO_LATE_MS = 300.0  # later than anybody who looks every 0.2 s: these have waited in a queue
EARLY_S = 0.001
PROCESSOR_SHARE = 0.05
NEVER_WAITS_SHARE = 0.4
WAITED_S = 0.1  # in the run queue: on a machine with little else to do it is a tenth of that


def drawn(rng: random.Random) -> list[see.Part]:
    """Draw sixty touches: eight one by one, two bunches, eight one by one, a bunch, and one more after a pause of 3 s.

    One by one they come at intervals (s) longer than the sleep of the starter, and out of step with it.
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
    """Draw the numbers of the touches: above 1000, with one left out and then many, or the other way round.

    They begin again at 1 three times: twice in a row, where touches come one by one, and in the middle of the last
    bunch. So 1 comes twice in a row, and the first numbers come again. Those before the last restart are greater than
    those after it. The size of a bunch is among them, but later than the first two bunches.
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


@dataclass(frozen=True)
class Touches:
    """The touches of the script, each known by its place, from 0 on: their numbers, and sets of places.

    `alone`: no other one came in the same moment. `after_skips`: numbers are missing before it. `restarts`: its number
    is no greater than the one before. `known`: its number had come before. `twice`: it has the number of the one
    before; `after_the_pause`: the first one after it; None if there is none. `apart_s`: from one that came alone to
    the next one.
    """

    numbers: list[int]
    alone: set[int]
    after_skips: set[int]
    restarts: set[int]
    known: set[int]
    twice: int | None
    after_the_pause: int | None
    apart_s: float


def touches(recording: Recording) -> Touches:
    """Read what the judge sent, and what was still to come when the program ended."""
    words = see.script(recording, TOUCH)
    numbers, at = [one.value["data"] for one in words], [one.t for one in words]
    steps = [(place, numbers[place] - numbers[place - 1]) for place in range(1, len(numbers))]
    apart = {place: at[place] - at[place - 1] for place in range(1, len(at))}
    alone = {
        place for place in range(len(at)) if min(apart.get(place, 1.0), apart.get(place + 1, 1.0)) > AT_ONCE_S
    }
    singly = [apart[place] for place in alone if place - 1 in alone]
    return Touches(
        numbers,
        alone,
        {place for place, step in steps if step > 1},
        {place for place, step in steps if step <= 0},
        {place for place, number in enumerate(numbers) if number in numbers[:place]},
        next((place for place, step in steps if step == 0), None),
        next((place for place, pause in apart.items() if pause > PAUSE_S), None),
        statistics.median(singly) if singly else 0.0,
    )


@criterion(
    points=1, title="It subscribes to /robot/touch and publishes on /monitor/seen", needs=[program_runs]
)
def topics(recording: Recording) -> Verdict:
    return see.all_of(
        see.listens(recording, topic(TOUCH, Int32)),
        see.publishes(recording, SEEN),
    )


@criterion(points=3, title="No touch is missed", needs=[topics])
def none_missed(recording: Recording) -> Verdict:
    nothing = see.no_message(recording, SEEN)
    if nothing is not None:
        return no_report(recording, nothing)
    came, numbers = set(places_of_reports(recording)), touches(recording).numbers
    missed = [place for place in range(len(numbers)) if place not in came]
    if not missed:
        return see.passed(f"all {len(numbers)} touches reported")
    return why_missed(recording, missed)


@criterion(points=2, title="No touch is reported twice, and the reports are in order", needs=[topics])
def once_in_order(recording: Recording) -> Verdict:
    expected = EACH_ONCE
    nothing = see.no_message(recording, SEEN)
    if nothing is not None:
        try_this = "Publish in the subscription's callback."
        return see.failed(nothing.cause, "no report at all", expected, nothing.because, try_this)
    numbers, sent = reported(recording), touches(recording).numbers
    strange = [number for number in numbers if number not in sent]
    if strange:
        return no_such_touch(strange, numbers, sent, expected)
    early = too_early(recording)
    places = places_of_reports(recording)
    twice = sorted({n for n, place in zip(numbers, places, strict=True) if place is None} - set(early))
    if twice:
        return see.failed(
            "once-in-order.twice",
            f"{see.count(len(twice), 'number')} reported more often than it was published: {some(twice)}",
            expected,
            "Two places report: the callback and a remaining loop or timer, or two subscriptions. Or your program "
            "reports a touch again later, although there's no new one.",
            "Report only in the callback.",
        )
    if early and {*range(len(sent))} <= {*places}:
        saw = (
            f"{early[0]} was reported before there was a touch with this number, in addition to the reports of "
            "all touches"
        )
        return see.failed("once-in-order.besides-all", saw, expected, *A_NUMBER_OF_ITS_OWN)
    if early:
        return see.failed(
            "once-in-order.ahead",
            f"{early[0]} was reported before there was a touch with this number",
            expected,
            "Your program reports the next touch's number instead of the current one's.",
            "Report message.data in the callback.",
        )
    return other_order([place for place in places if place is not None], sent, expected) or see.passed(
        f"{len(numbers)} reports, in order"
    )


@criterion(points=2, title="Reports come within a few milliseconds", needs=[topics])
def quick(recording: Recording) -> Verdict:
    expected = (
        f"three in four of the touches that arrive alone within {ALONE_MS:g} ms; half of those that arrive together "
        f"within {TOGETHER_MS:g} ms"
    )
    alone, together = late_ms(recording, alone=True), late_ms(recording, alone=False)
    if not alone and not together:
        return see.failed(
            "quick.nothing-reported",
            "no report that could be timed",
            expected,
            "No touch was reported.",
            "Publish message.data in the subscription's callback.",
        )
    soon = sum(one <= ALONE_MS for one in alone)
    if soon < ALONE_SHARE * len(alone):
        typical = statistics.median(alone)
        saw = (
            f"{soon} of {len(alone)} touches that arrived alone within {ALONE_MS:g} ms; typically {typical:.0f} "
            "ms"
        )
        return why_late(recording, alone, saw, expected)
    half = statistics.median(together) if together else 0.0
    if half > TOGETHER_MS:
        return see.failed(
            "quick.cannot-keep-up",
            f"of the touches that arrived together, half were reported later than {half:.0f} ms",
            expected,
            "Touches wait in a queue, because your program takes them out too slowly.",
            REPORT_IN_THE_CALLBACK,
            about_time=True,
        )
    typical = statistics.median(alone) if alone else half
    return see.passed(f"typically {typical:.1f} ms")


@criterion(points=1, title="It uses hardly any CPU time", needs=[topics])
def easy_on_processor(recording: Recording) -> Verdict:
    walls = [one.wall for one in see.published(recording, TOUCH)]
    place = touches(recording).after_the_pause or len(walls)
    begin, end = (walls[place - 1] + REPORTED_BY_S, walls[place]) if len(walls) > place else (None, None)
    share = see.processor_share(recording, begin, end)
    if share is None or share <= PROCESSOR_SHARE:
        return see.passed("hardly any processor time" if share is None else f"{share:.0%} of a processor")
    expected = f"less than {PROCESSOR_SHARE:.0%}: without touches, there is nothing to do"
    saw = f"{share:.1%} of a processor while there was no touch"
    if share < NEVER_WAITS_SHARE < share + recording.in_line_s / recording.simulated_s:
        return see.failed(
            "easy-on-processor.wants-more",
            f"{saw}. Your program was ready to use more, but waited for a busy processor for "
            f"{recording.in_line_s:.1f} s in all",
            expected,
            "A loop never waits: while True without a sleep, or spin_once with timeout_sec=0. Or a timer or a "
            "sleep is very short. The machine was too busy for the judge to see which.",
            "Remove that loop or timer, and let rclpy.spin(node) wait for the next touch.",
        )
    if share < NEVER_WAITS_SHARE:
        return see.failed(
            "easy-on-processor.wakes-too-often",
            saw,
            expected,
            "Your program wakes up many hundred times per second. A timer has a very short period, or a loop has a "
            "very short sleep. Or it sometimes computes something although there's no touch.",
            "Remove that timer or loop, and let rclpy.spin(node) wait for the next touch.",
        )
    return see.failed(
        "easy-on-processor.never-waits",
        saw,
        expected,
        "A loop never waits: while True without a sleep, or spin_once with timeout_sec=0.",
        "Let rclpy.spin(node) wait. The operating system wakes it up when a callback is ready.",
    )


@criterion(points=1, title="The program is still alive at the end", needs=[program_runs])
def alive_at_end(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)


# --- the reports --------------------------------------------------------------------------------------------


def reported(recording: Recording) -> list[int]:
    """The numbers that were reported, in the order of their arrival."""
    return [arrival.value["data"] for arrival in recording.topic(SEEN.name).arrivals]


@see.once
def places_of_reports(recording: Recording) -> list[int | None]:
    """For each report the place of its touch: of those that came before it and have no report yet, the first after the
    touch that was reported last (of two in a row with one number the second), otherwise the latest. None if there is
    none.
    """
    words = see.published(recording, TOUCH)
    found: list[int | None] = []
    taken: set[int | None] = set()
    last = -1
    for arrival in recording.topic(SEEN.name).arrivals:
        free = [
            place
            for place, word in enumerate(words)
            if word.value["data"] == arrival.value["data"]
            and word.wall - EARLY_S <= arrival.published
            and place not in taken
        ]
        place = next((one for one in free if one > last and one + 1 not in free), free[-1] if free else None)
        found.append(place)
        taken.add(place)
        last = last if place is None else place
    return found


def moments_of_reports(recording: Recording) -> dict[int, float]:
    """When (s of wall time) each touch was reported, by its place.

    Where other numbers are reported, and as many as there were touches, the first belongs to the first, and so on.
    """
    arrivals, sent = recording.topic(SEEN.name).arrivals, touches(recording).numbers
    places = places_of_reports(recording)
    if len(arrivals) == len(sent) and any(number not in sent for number in reported(recording)):
        places = [*range(len(sent))]
    return {place: one.published for place, one in zip(places, arrivals, strict=True) if place is not None}


def late_ms(recording: Recording, *, alone: bool) -> list[float]:
    """How late (ms) the touches were reported that came alone, or those that came together."""
    moments, those_alone = moments_of_reports(recording), touches(recording).alone
    return [
        1000.0 * (moments[place] - word.wall)
        for place, word in enumerate(see.published(recording, TOUCH))
        if place in moments and (place in those_alone) is alone
    ]


def typically_late_ms(recording: Recording) -> float | None:
    """How late a report typically is (ms); None if no touch was reported."""
    late = late_ms(recording, alone=True) + late_ms(recording, alone=False)
    return statistics.median(late) if late else None


def too_early(recording: Recording) -> list[int]:
    """The numbers that were reported before they came for the first time."""
    first: dict[int, float] = {}
    for one in see.published(recording, TOUCH):
        first.setdefault(one.value["data"], one.wall)
    return [
        number
        for one in recording.topic(SEEN.name).arrivals
        if one.published < first.get(number := one.value["data"], -math.inf) - EARLY_S
    ]


def some(numbers: list[int]) -> str:
    """A few of these numbers, as one says them."""
    words = [str(number) for number in numbers[:4]]
    return ", ".join(words) + (", …" if len(numbers) > 4 else "")


def no_report(recording: Recording, nothing: Verdict) -> Verdict:
    """Not one report arrived, for the reason of `nothing` where an error is to blame."""
    sent = len(touches(recording).numbers)
    saw, expected = f"no report for {sent} touches", f"all {sent} of them on {SEEN.name}"
    try_this = "Spin the node, and publish in the subscription's callback."
    if "Error" in nothing.saw:
        return see.failed(nothing.cause, saw, expected, nothing.because, try_this)
    return see.asks_for_other_qos(recording, TOUCH, saw, expected) or see.failed(
        "none-missed.no-report",
        saw,
        expected,
        "The callback never runs, or it doesn't publish.",
        try_this,
    )


REPORT_IN_THE_CALLBACK = (
    "Report in the subscription's callback, keep it short, and let rclpy.spin wait for the next touch."
)
EACH_ONCE = "each number once, in the order of the touches"
NOT_WHAT_THE_MESSAGE_SAYS = (
    "Your program reports something other than the number in the message: its own counter, an initial value, or a "
    "computed number.",
    "Report message.data.",
)
A_NUMBER_OF_ITS_OWN = (
    "Your program also reports a number that isn't a touch: at the start, in a pause, after a burst, or when the "
    "skin restarts.",
    "Report only the touches that arrive.",
)
IN_ONE_BYTE = (
    "The number is stored in one byte, so it wraps to 0 after 255.",
    "Report message.data unchanged.",
)


def no_such_touch(strange: list[int], numbers: list[int], sent: list[int], expected: str) -> Verdict:
    """Numbers were reported that no touch has: those that the skin left out, cut off ones, or others."""
    saw = f"touch {strange[0]} was reported, but there was no such touch"
    left_out = {*range(1, max(sent))} - {*sent}
    if left_out.issuperset(strange) and set(numbers).issuperset(sent):
        return see.failed(
            "once-in-order.gap-filled",
            f"{saw}; {see.count(len(strange), 'such report')} in all",
            expected,
            "Your program also reports the skipped numbers.",
            "Report only the touches that arrive.",
        )
    if set(numbers).issuperset(sent):
        return see.failed(
            "once-in-order.something-else",
            f"{saw}; {see.count(len(strange), 'such report')} in all, in addition to those of all touches",
            expected,
            *A_NUMBER_OF_ITS_OWN,
        )
    if cut_off(numbers, sent):
        return see.failed("once-in-order.cut-off", saw, expected, *IN_ONE_BYTE)
    return see.failed("once-in-order.no-touch", saw, expected, *NOT_WHAT_THE_MESSAGE_SAYS)


def other_order(places: list[int], sent: list[int], expected: str) -> Verdict | None:
    """The touches were reported in another order than they came."""
    back = [(a, b) for a, b in pairwise(places) if b < a and sent[a] != sent[b]]
    if not back:
        return None
    saw = f"touch {sent[back[0][1]]} was reported after {sent[back[0][0]]}, which arrived later"
    if all(sent[b] > sent[a] for a, b in back):
        return see.failed(
            "once-in-order.sorted",
            saw,
            expected,
            "Your program sorts touches that arrive together by their numbers. But the skin had restarted at 1 "
            "between them.",
            "Report in the callback, one touch after another, in the order of arrival.",
        )
    return see.failed(
        "once-in-order.other-order",
        saw,
        expected,
        "Your program reports the newest touch first (pop() takes the end of a list), or it keeps touches in a "
        "set. Or several threads report at the same time.",
        "Report in the callback, one touch after another, in one thread.",
    )


def cut_off(numbers: list[int], sent: list[int]) -> bool:
    """Whether only the lowest byte of each number is reported."""
    return any(number not in sent for number in numbers) and numbers == [one % 256 for one in sent]


def why_late(recording: Recording, alone: Sequence[float], saw: str, expected: str) -> Verdict:
    """Reports go out with the next touch, several together, or each by itself."""
    typical, sent = statistics.median(alone), touches(recording)
    at = sorted(moment for place, moment in moments_of_reports(recording).items() if place in sent.alone)
    close = sum(b - a < AT_ONCE_S for a, b in pairwise(at))
    if abs(typical - 1000.0 * sent.apart_s) < ALONE_MS and close < MOSTLY * len(at):
        return see.failed(
            "quick.with-the-next",
            saw,
            expected,
            f"The next touch arrives {1000.0 * sent.apart_s:.0f} ms later, so your program reports a touch only "
            "when the next one arrives.",
            REPORT_IN_THE_CALLBACK,
            about_time=True,
        )
    if close >= MOSTLY * len(at):
        return see.failed(
            "quick.collected",
            f"{saw}; touches that arrived alone were reported together",
            expected,
            "Your program collects touches until there are enough of them, or until a loop or timer checks them.",
            REPORT_IN_THE_CALLBACK,
            about_time=True,
        )
    return why_each_late(recording, alone, saw, expected)


def why_each_late(recording: Recording, alone: Sequence[float], saw: str, expected: str) -> Verdict:
    """Each report is held back for the same time, waits until somebody looks, or falls behind; or it may be chance."""
    typical = statistics.median(alone)
    if typical < 3.0 * ALONE_MS and recording.in_line_s > WAITED_S:
        return why_busy(f"{saw}; the program waited {recording.in_line_s:.1f} s for a processor", expected)
    if sum(abs(one - typical) < 0.1 * typical for one in alone) >= ALONE_SHARE * len(alone):
        return see.failed(
            "quick.held-back",
            saw,
            expected,
            "All reports are late by the same time. Something slow runs before publish(), such as a sleep, or a "
            "timer publishes later.",
            REPORT_IN_THE_CALLBACK,
            about_time=True,
        )
    if typical < TOO_LATE_MS:
        return see.failed(
            "quick.polls",
            saw,
            expected,
            "A touch waits until a loop or timer polls: half a period on average. A queue that's emptied at each "
            "poll loses no touches, but the delay is the same. Or something slow runs before publish().",
            REPORT_IN_THE_CALLBACK,
            about_time=True,
        )
    return see.failed(
        "quick.falls-behind",
        saw,
        expected,
        "Touches wait in a queue, because your program takes them out too slowly.",
        REPORT_IN_THE_CALLBACK,
        about_time=True,
    )


def why_busy(saw: str, expected: str) -> Verdict:
    """Reports are late by a few hundredths of a second, and the machine was busy."""
    return see.failed(
        "quick.busy-machine",
        saw,
        expected,
        "The machine was busy, so this may be chance. Or something waits a few hundredths of a second before it "
        "reports.",
        REPORT_IN_THE_CALLBACK,
        about_time=True,
    )


def why_missed(recording: Recording, missed: list[int]) -> Verdict:
    """Touches were missed: something else was reported, it is too slow, it has stopped, or it polls."""
    touch = touches(recording)
    sent = touch.numbers
    saw = f"{len(missed)} of {len(sent)} touches missed: {some([sent[place] for place in missed])}"
    expected = f"a report for each of the {len(sent)} touches"
    numbers = reported(recording)
    strange = [number for number in numbers if number not in sent]
    if strange:
        saw = f"{saw}; {strange[0]} was reported, but there was no such touch"
        if cut_off(numbers, sent):
            return see.failed("none-missed.cut-off", saw, expected, *IN_ONE_BYTE)
        return see.failed("none-missed.no-touch", saw, expected, *NOT_WHAT_THE_MESSAGE_SAYS)
    if particular := first_or_last(touch, missed, saw, expected) or numbers_taken_amiss(
        touch, set(missed), saw, expected
    ):
        return particular
    late_ms = typically_late_ms(recording) or 0.0
    if late_ms > TOO_LATE_MS:
        return see.failed(
            "none-missed.cannot-keep-up",
            f"{saw} (and the others were reported {late_ms:.0f} ms late)",
            expected,
            "Touches wait in a queue, because your program takes them out too slowly. The callback is slow, or a "
            "loop sleeps between calls to spin_once, which handles one message each. A full queue drops touches.",
            "Keep the callback short, and let rclpy.spin call it for every message.",
            about_time=True,
        )
    place = missed[0]
    if missed == [*range(place, len(sent))]:
        after = f"nothing after touch {sent[place - 1]}" if place > 0 else "no report"
        error = see.ended_by_error(recording, f"{after}: {len(missed)} missed", expected)
        if error is not None:
            return error
    if place > 0 and missed == [*range(place, len(sent))]:
        nothing = f"nothing after touch {sent[place - 1]}: {len(missed)} missed"
        return why_nothing_more(recording, nothing, expected)
    return missed_now_and_then(touch, missed, saw, expected)


def why_nothing_more(recording: Recording, nothing: str, expected: str) -> Verdict:
    """All touches after one were missed."""
    if recording.process.ended_by == "itself":
        return see.failed(
            "none-missed.ended",
            f"{nothing}, because the program ended by itself",
            expected,
            "Your program stops spinning: the spin has a time limit, or a loop ends when there's no touch for a "
            "while.",
            "Let rclpy.spin(node) run until Ctrl-C, no matter how long the pauses between touches are.",
        )
    return see.failed(
        "none-missed.stops",
        nothing,
        expected,
        "Something has stopped: an exception in the callback, a loop or thread that ended (in a pause without "
        "touches?), or the spin of the node. Or a counter limits the number of reports.",
        "Read the log, and let rclpy.spin(node) run until Ctrl-C.",
    )


def first_or_last(touch: Touches, missed: list[int], saw: str, expected: str) -> Verdict | None:
    """Only the first touch was missed, only the last, or all with numbers of a kind."""
    if missed == [0]:
        return see.failed(
            "none-missed.the-first",
            saw,
            expected,
            "Only the first touch is missing. Your program treats it as a test, or as an initial value to compare "
            "with.",
            "Report every touch, including the first one.",
        )
    if missed == [touch.after_the_pause]:
        return see.failed(
            "none-missed.after-the-pause",
            f"{saw}, the first one after three seconds without touches",
            expected,
            "After a pause, your program doesn't report the next touch. The touch only wakes something up, or your "
            "program treats it as an initial value.",
            "Report every touch, no matter how long the pause before it was.",
        )
    if missed == [len(touch.numbers) - 1]:
        return see.failed(
            "none-missed.the-last",
            saw,
            expected,
            "Only the last touch is missing, because your program reports a touch only when the next one arrives.",
            "Report each touch in the callback that receives it.",
        )
    return of_a_kind(touch, missed, saw, expected)


def of_a_kind(touch: Touches, missed: list[int], saw: str, expected: str) -> Verdict | None:
    """Only touches with small numbers were missed, or only those with great ones."""
    if missed == [*range(min(touch.restarts, default=0), len(touch.numbers))]:
        return see.failed(
            "none-missed.smaller-numbers",
            f"{saw}: nothing after the skin restarted at 1",
            expected,
            "Your program treats a number that's smaller than the previous one as old.",
            "Report each touch, no matter what its number is.",
        )
    if len(missed) > 1 and missed == [place for place, number in enumerate(touch.numbers) if number > 60]:
        return see.failed(
            "none-missed.greater-numbers",
            saw,
            expected,
            "Your program reports only small numbers. But a touch may have any number.",
            "Report each touch, no matter what its number is.",
        )
    return None


def numbers_taken_amiss(touch: Touches, missed: set[int], saw: str, expected: str) -> Verdict | None:
    """Only touches were missed whose number is not one more than the one before, or has come before."""
    report_each = "Report each touch, no matter what its number is."
    if touch.twice in missed and missed <= touch.known:
        return see.failed(
            "none-missed.number-known",
            f"{saw}, where a number was repeated after the skin had restarted at 1",
            expected,
            "Your program drops a touch as a duplicate if its number has occurred before, or is equal to the "
            "previous one.",
            report_each,
        )
    if missed & touch.after_skips and missed <= touch.after_skips | touch.restarts:
        return see.failed(
            "none-missed.after-a-gap",
            f"{saw}, where the skin had skipped a number",
            expected,
            "Your program treats a touch as an error if its number isn't one more than the previous one.",
            report_each,
        )
    if min(touch.restarts, default=None) in missed and missed <= touch.restarts:
        return see.failed(
            "none-missed.at-the-restart",
            f"{saw}, where the skin restarted at 1",
            expected,
            "Your program treats a touch as old, or as an initial value, if its number is smaller than the "
            "previous one.",
            report_each,
        )
    return None


def missed_now_and_then(touch: Touches, missed: list[int], saw: str, expected: str) -> Verdict:
    """Touches were missed here and there: those that came together, or any."""
    together = sum(place not in touch.alone for place in missed)
    if together >= MOSTLY * len(missed):
        which = "it" if len(missed) == 1 else "all of them" if together == len(missed) else "most of them"
        return see.failed(
            "none-missed.came-together",
            f"{saw}; {which} arrived together with others",
            expected,
            "Your program can't store several touches that arrive at the same time. A variable holds only the last "
            "one, a queue has a small depth, or the program skips touches that follow another one too soon.",
            "Report in the callback itself, and give the subscription a depth large enough for a burst.",
            about_time=True,
        )
    return see.failed(
        "none-missed.polls",
        saw,
        expected,
        "Your program polls: it checks the last touch from time to time, so touches in between are lost.",
        "Report each touch in the callback when it arrives, and remove the polling loop.",
        about_time=True,
    )
