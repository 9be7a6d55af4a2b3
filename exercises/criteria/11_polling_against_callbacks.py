"""How exercise 11 is judged: sixty numbered touches, and when each of them is reported."""

import statistics

from std_msgs.msg import Int32

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, topic, watching

TOUCH = "/robot/touch"
SEEN = topic("/monitor/seen", Int32)

SPACING_S = 0.231  # longer than the sleep of the starter, and out of step with it
SINGLE = [start + SPACING_S * n for start in (0.4, 3.1) for n in range(8)]
BUNCHES = (2.4, 2.75, 5.1, 5.45)  # (s) several in one moment; spread evenly over a sleep of 0.2 s
IN_A_BUNCH = 11
MOMENTS = sorted([*SINGLE, *(at for at in BUNCHES for _ in range(IN_A_BUNCH))])
TOUCHES = range(1, len(MOMENTS) + 1)

LATEST_MS = 40.0  # typically: a callback needs a few ms, a look every 0.2 s finds things after about 100 ms
MOSTLY = 0.7
TOO_LATE_MS = 300.0  # later than anybody who looks every 0.2 s: these have waited in a queue
PROCESSOR_SHARE = 0.05

WATCH = watching(
    wall_seconds=6.5,
    script=[see.says(TOUCH, Int32, list(zip(MOMENTS, TOUCHES, strict=True)))],
)


def reported(recording: Recording) -> list[int]:
    """The numbers that were reported, in the order of their arrival."""
    return [arrival.value["data"] for arrival in recording.topic(SEEN.name).arrivals]


def typically_late_ms(recording: Recording) -> float | None:
    """How late a report typically is (ms); None if no touch was reported."""
    found = see.latencies(see.said(recording, TOUCH), recording.topic(SEEN.name).arrivals)
    late = [1000.0 * seconds for seconds in found if seconds is not None]
    return statistics.median(late) if late else None


def some(numbers: list[int]) -> str:
    """A few of these numbers, as one says them."""
    words = [str(number) for number in numbers[:4]]
    return ", ".join(words) + (", …" if len(numbers) > 4 else "")


@criterion(points=0, title="Your program runs and its node is on the graph")
def program_runs(recording: Recording) -> Verdict:
    return see.program_runs(recording)


@criterion(points=1, title="It listens to /robot/touch and reports on /monitor/seen", needs=[program_runs])
def topics(recording: Recording) -> Verdict:
    return see.all_of(
        see.listens(recording, topic(TOUCH, Int32)),
        see.publishes(recording, SEEN),
    )


@criterion(points=3, title="No touch is missed", needs=[topics])
def none_missed(recording: Recording) -> Verdict:
    nothing = see.no_message(recording, SEEN)
    if nothing is not None:
        return see.failed(
            f"not one report for {len(TOUCHES)} touches",
            f"all {len(TOUCHES)} of them on {SEEN.name}",
            nothing.because
            if "Error" in nothing.saw
            else "The callback is never called, or nobody publishes in it.",
            "Spin the node, and publish in the callback of the subscription.",
        )
    missed = [number for number in TOUCHES if number not in set(reported(recording))]
    if not missed:
        return see.passed(f"all {len(TOUCHES)} touches reported")
    saw = f"{len(missed)} of {len(TOUCHES)} touches missed: {some(missed)}"
    expected = f"each of the {len(TOUCHES)} touches reported"
    strange = [number for number in reported(recording) if number not in TOUCHES]
    if strange:
        return see.failed(
            f"{saw}; and {strange[0]} was reported, which was no touch",
            expected,
            "A counter of your own, or a start value, is reported in place of what the message says.",
            "Report message.data.",
        )
    late_ms = typically_late_ms(recording) or 0.0
    if late_ms > TOO_LATE_MS:
        return see.failed(
            f"{saw} (and the others came {late_ms:.0f} ms late)",
            expected,
            "The touches wait in a queue, and the one who takes them out cannot keep up: the callback itself takes "
            "long, or a loop sleeps and calls spin_once, which handles one message. A full queue lets touches go.",
            "Keep the callback short, and let rclpy.spin call it as often as there is something to do.",
            about_time=True,
        )
    if missed[0] > 1 and missed == list(range(missed[0], len(TOUCHES) + 1)):
        return see.failed(
            f"nothing after touch {missed[0] - 1}: {len(missed)} missed",
            expected,
            "Something has stopped: an exception in the callback, a loop that has come to its end, or a node that "
            "nobody spins any more.",
            "Look into the log, and let rclpy.spin(node) run until Ctrl-C.",
        )
    together = sum(MOMENTS.count(MOMENTS[number - 1]) > 1 for number in missed)
    if together >= MOSTLY * len(missed):
        return see.failed(
            f"{saw}, {'only' if together == len(missed) else 'mostly'} such as came together with others",
            expected,
            "When several come in one moment there is room for too few: one variable that holds the last touch until "
            "somebody looks, or a queue with a small depth. No sleep is short enough for that.",
            "Report in the callback itself, and give the subscription a depth that holds a bunch.",
            about_time=True,
        )
    return see.failed(
        saw,
        expected,
        "Somebody looks now and then at the last touch, and what came in between is gone.",
        "Let the callback report each touch when it comes; do away with the loop that looks.",
        about_time=True,
    )


@criterion(points=2, title="None is reported twice, and all in order", needs=[topics])
def once_in_order(recording: Recording) -> Verdict:
    numbers = reported(recording)
    expected = "each number once, in the order of the touches"
    nothing = see.no_message(recording, SEEN)
    if nothing is not None:
        return see.failed(
            "no report at all", expected, nothing.because, "Publish in the callback of the subscription."
        )
    strange = [number for number in numbers if number not in TOUCHES]
    if strange:
        return see.failed(
            f"touch {strange[0]} was reported, and there was no such touch",
            expected,
            "A counter of your own, or a start value, is reported in place of what the message says.",
            "Report message.data.",
        )
    twice = sorted({number for number in numbers if numbers.count(number) > 1})
    if twice:
        return see.failed(
            f"{len(twice)} touches reported more than once: {some(twice)}",
            expected,
            "Two places report: the callback and a loop or timer that is still there, two subscriptions, or a look "
            "that does not notice that nothing is new.",
            "Keep one place that reports: the callback.",
        )
    late = next((b for a, b in zip(numbers, numbers[1:], strict=False) if b < a), None)
    if late is not None:
        return see.failed(
            f"touch {late} was reported after a later one",
            expected,
            "The newest is taken first (pop() takes from the end of a list), or several threads report at once.",
            "Report in the callback, one after the other, in one thread.",
        )
    return see.passed(f"{len(numbers)} reports, in order")


@criterion(points=2, title="A report typically comes within a few milliseconds", needs=[topics])
def quick(recording: Recording) -> Verdict:
    typical = typically_late_ms(recording)
    expected = (
        f"typically no more than {LATEST_MS:g} ms from the touch to its report (a callback needs a few)"
    )
    if typical is None:
        return see.failed(
            "no report that could be timed",
            expected,
            "Nothing of what was touched has been reported.",
            "Publish message.data in the callback of the subscription.",
        )
    if typical <= LATEST_MS:
        return see.passed(f"typically {typical:.1f} ms")
    return see.failed(
        f"typically {typical:.0f} ms late",
        expected,
        "A touch waits until somebody looks: for half of the sleep, on average. A queue that is emptied with each look "
        "loses nothing, but is just as late."
        if typical < TOO_LATE_MS
        else "The touches wait in a queue, and the one who takes them out cannot keep up.",
        "Report in the callback of the subscription, keep it short, and let rclpy.spin wait for the next touch.",
        about_time=True,
    )


@criterion(points=1, title="It leaves the processor alone", needs=[topics])
def easy_on_processor(recording: Recording) -> Verdict:
    walls = [one.wall for one in see.said(recording, TOUCH)]
    share = see.processor_share(recording, begin=walls[0] if walls else None)
    if share is None or share <= PROCESSOR_SHARE:
        return see.passed("hardly any processor time" if share is None else f"{share:.0%} of a processor")
    return see.failed(
        f"{share:.0%} of a processor, all the time",
        f"less than {PROCESSOR_SHARE:.0%}: between two touches there is nothing to do",
        "A loop runs without ever waiting: while True without a sleep, or spin_once with timeout_sec=0.",
        "Let rclpy.spin(node) wait. The operating system wakes it when there is something to do.",
    )


@criterion(points=1, title="The program is still alive at the end", needs=[program_runs])
def alive_at_end(recording: Recording) -> Verdict:
    return see.alive_at_end(recording)
