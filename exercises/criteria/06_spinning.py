"""How exercise 06 is judged: a driver calls `pump` four times, and everything that the nodes did is on the topics."""

from dataclasses import dataclass, replace

from std_msgs.msg import Int32, Int32MultiArray, String

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, topic, watching
from workbook.criteria.mishaps import find_mishap

HEARTBEAT = topic("/robot/heartbeat", Int32MultiArray)
LOOK = topic("/robot/look", Int32MultiArray)
HEARD = topic("/robot/heard", Int32MultiArray)
JOB_BEGUN = topic("/robot/job_begun", Int32MultiArray)
QUIET_HEARD = topic("/quiet/heard", Int32MultiArray)
PUMP = topic("/driver/pump", String)

BURST, AGAIN, SLOW, QUIET = 1, 2, 3, 4
ASKED_S = {BURST: 1.5, AGAIN: 1.4, SLOW: 0.8, QUIET: 1.6}
BURST_WORDS = range(1, 21)
WAITING_WORDS = range(21, 26)
JOBS = range(1, 8)
JOB_S = 0.4
HEARTBEAT_PERIOD_S = 0.1

EARLY_S = 0.2
LATE_S = 0.8
DELAY_S = 1.5  # longer than a message needs to arrive, on however busy a machine
PROCESSOR_SHARE = 0.12


def ordered(at: float, order: str) -> list[tuple[float, str]]:
    """An order, given three times: the driver carries it out once."""
    return [(at + 0.1 * again, order) for again in range(3)]


WATCH = watching(
    wall_seconds=8.5,
    script=[
        see.says(
            "/driver/go",
            String,
            [
                *ordered(0.2, "1 robot 1.5"),
                *ordered(2.2, "2 robot 1.4"),
                *ordered(3.9, "3 robot 0.8"),
                *ordered(5.2, "4 quiet_robot 1.6"),
            ],
        ),
        see.says(
            "/robot/words",
            Int32,
            [
                *((0.25, word) for word in BURST_WORDS),
                *(
                    (at, 0) for at in (0.4, 0.6, 0.9)
                ),  # the 0 is not judged: a message may hang until the next one
                *((1.9, word) for word in WAITING_WORDS),
                *((at, 0) for at in (2.3, 2.5, 2.7)),
            ],
        ),
        see.says("/robot/jobs", Int32, [(3.7, job) for job in JOBS]),
        # Late in the call, so that a wait that begins anew shows, even when the call itself began half a second late.
        see.says("/quiet/words", Int32, [(6.55, 1), (6.62, 2)]),
    ],
)


@dataclass(frozen=True)
class Call:
    """One call of `pump`: when it began and came back (s of wall time), how long it took (s), what it raised."""

    begin: float
    end: float | None = None
    took: float | None = None
    raised: str | None = None


def calls(recording: Recording) -> dict[int, Call]:
    """The calls of `pump` by their number, as the driver announced them."""
    found: dict[int, Call] = {}
    for arrival in recording.topic(PUMP.name).arrivals:
        word, _, rest = arrival.value["data"].partition(" ")
        number, _, news = rest.partition(" ")
        if word == "missing":
            continue
        call = found.setdefault(int(number), Call(arrival.published))
        if word == "raised":
            found[int(number)] = replace(call, raised=news)
        elif word == "end" and call.end is None:
            found[int(number)] = finished(call, arrival.published, float(news))
    return found


def finished(call: Call, end: float, took: float) -> Call:
    """The call with its end. What the driver measured is more exact than when its words arrived, and must fit them."""
    if abs(end - call.begin - took) > DELAY_S:
        took = end - call.begin
    return replace(call, begin=min(call.begin, end - took), end=end, took=took)


def done_in(recording: Recording, name: str, call: int) -> list[int]:
    """The numbers that a robot told on a topic of what it did in a call; 0: between the calls."""
    pairs = [arrival.value["data"] for arrival in recording.topic(name).arrivals]
    return [number for told, number in pairs if told == call]


def came_back(recording: Recording, number: int) -> Verdict | None:
    """None if the call came back; otherwise what to say about it."""
    asked = ASKED_S[number]
    expected = f"pump(node, {asked}) comes back when the time is up"
    call = calls(recording).get(number)
    if call is None:
        return see.failed(
            "the call before it never came back",
            expected,
            "Something waits without an end.",
            "Give every wait a timeout_sec that is not longer than the time that is left.",
        )
    if call.raised is not None:
        return see.failed(
            f"the first call was fine; call {number} raised {call.raised}",
            expected,
            "The node, its executor or ROS itself was gone when pump was called again.",
            "Leave the node and the context as you found them: they are not yours to destroy or to shut down.",
        )
    return None


def in_time(recording: Recording, number: int, extra: float = 0.0) -> Verdict:
    """The call took as long as asked; `extra` seconds more are granted on top of what is granted anyway."""
    gone = came_back(recording, number)
    if gone is not None:
        return gone
    call = calls(recording)[number]
    asked = ASKED_S[number]
    expected = f"back after {asked} s"
    took = call.took
    if took is None and recording.wall_s - call.begin < asked + extra + LATE_S:
        return see.passed("the watch was over before its time was")
    if took is None:
        return see.failed(
            f"not back {recording.wall_s - call.begin - asked:.1f} s after its time was up",
            expected,
            "spin_once without a timeout waits until there is something to do, if need be forever. "
            "And a timeout that begins anew after each callback may add up.",
            "Before each spin_once, work out how much time is left, and give it that as timeout_sec.",
            about_time=True,
        )
    if took < asked - EARLY_S:
        return see.failed(
            f"back after {took:.2f} s",
            f"{expected}, not earlier",
            "Callbacks were counted, and not time: a callback that is ready ends the wait of spin_once at once.",
            "Note time.monotonic() + seconds at the start, and go on until that moment.",
        )
    if took > asked + extra + LATE_S:
        return see.failed(
            f"back after {took:.2f} s",
            expected,
            "After a callback the wait began anew with its full length."
            if number == QUIET
            else "The time that callbacks take is not counted, or everything is handled before you look at the clock.",
            "Before each spin_once, work out how much time is left, and give it that as timeout_sec.",
            about_time=True,
        )
    return see.passed(f"asked for {asked} s, took {took:.2f} s")


@criterion(points=0, title="Your file loads, and pump can be called")
def program_runs(recording: Recording) -> Verdict:
    loaded = see.program_runs(recording)
    if not loaded.ok:
        return loaded
    first = calls(recording).get(BURST)
    mishap = find_mishap(recording.process.log, recording.process.program)
    if first is not None and first.raised is not None:
        return see.failed(
            f"{mishap.where if mishap else ''}pump raised {first.raised}",
            f"pump(node, {ASKED_S[BURST]}) runs without an error",
            mishap.because if mishap else "An exception left your function.",
            mishap.try_this if mishap else "Read the last lines of the log from the bottom up.",
        )
    said = [arrival.value["data"] for arrival in recording.topic(PUMP.name).arrivals]
    if "missing" in said:
        return see.failed(
            "your file has no function of the name pump",
            "def pump(node, seconds), at the left margin of the file",
            "The name is spelled in another way, or the function sits inside of another one.",
            "Write def pump(node: Node, seconds: float) -> None: at the left margin.",
        )
    return loaded


@criterion(points=1, title="pump comes back", needs=[program_runs])
def returns(recording: Recording) -> Verdict:
    gone = came_back(recording, BURST)
    if gone is not None:
        return gone
    call = calls(recording)[BURST]
    if call.end is not None:
        return see.passed("it came back")
    return see.failed(
        f"not back {recording.wall_s - call.begin - ASKED_S[BURST]:.1f} s after its time was up",
        f"pump(node, {ASKED_S[BURST]}) comes back",
        "rclpy.spin and executor.spin know no end: they come back when ROS is shut down. Or the moment that ends "
        "your loop is never reached: `seconds` are seconds.",
        "Use rclpy.spin_once(node, timeout_sec=...) in a loop that looks at the clock.",
        about_time=True,
    )


@criterion(points=1, title="It comes back when the time is up: not earlier, not later", needs=[returns])
def returns_in_time(recording: Recording) -> Verdict:
    return in_time(recording, BURST)


@criterion(points=2, title="Every word of a burst is handled while it pumps", needs=[program_runs])
def words_handled(recording: Recording) -> Verdict:
    got = [word for word in done_in(recording, HEARD.name, BURST) if word in BURST_WORDS]
    words = len(BURST_WORDS)
    if sorted(got) == list(BURST_WORDS):
        return see.passed(f"{words} of {words} words handled")
    if len(got) > words:
        return see.failed(
            f"{len(got)} words handled, and only {words} were said",
            f"each of the {words} words once",
            "The node has a second subscription now, or its callback is called by hand.",
            "Leave the node as it is, and let spin_once call the callbacks.",
        )
    return see.failed(
        f"{len(got)} of {words} words handled during the call",
        f"all {words} words that came while it pumped",
        "One spin_once runs one callback. What else is ready waits for the next spin_once."
        if got
        else "Nothing lets this node work while time passes. sleep keeps the callbacks waiting, too, and spinning "
        "another node does not help this one.",
        "Call rclpy.spin_once(node, timeout_sec=...) again and again until the time is up, without a sleep.",
        about_time=True,
    )


@criterion(points=1, title="The timers go on at their rate meanwhile", needs=[words_handled])
def timers_tick(recording: Recording) -> Verdict:
    asked = ASKED_S[BURST]
    wanted = round(asked / HEARTBEAT_PERIOD_S)
    beats, looks = (done_in(recording, one.name, BURST) for one in (HEARTBEAT, LOOK))
    if len(beats) >= 0.4 * wanted and looks:
        return see.passed(f"{len(beats)} heartbeats in {asked} s, and it looked around")
    return see.failed(
        f"{len(beats)} heartbeats and {len(looks)} looks around in {asked} s",
        f"about {wanted} heartbeats and 3 looks",
        "A timer ticks only while somebody spins, and one spin_once runs one callback.",
        "Spin until the time is up, and never sleep in between.",
        about_time=True,
    )


@criterion(points=1, title="A second call does it again", needs=[returns, words_handled])
def again(recording: Recording) -> Verdict:
    gone = came_back(recording, AGAIN)
    if gone is not None:
        return gone
    took = calls(recording)[AGAIN].took
    if took is not None and took < ASKED_S[AGAIN] - EARLY_S:
        return see.failed(
            f"the first call was fine; the second came back after {took:.2f} s",
            f"back after {ASKED_S[AGAIN]} s",
            "Something of the first call is still there, and ends the second one: a timer, a flag, a future.",
            "Destroy what you made on the node (node.destroy_timer), and make it anew in each call.",
        )
    told = [*done_in(recording, HEARD.name, BURST), *done_in(recording, HEARD.name, AGAIN)]
    got = set(told) & set(WAITING_WORDS)
    beats = done_in(recording, HEARTBEAT.name, AGAIN)
    if len(got) == len(WAITING_WORDS) and len(beats) >= 3:
        return see.passed(f"{len(got)} waiting words and {len(beats)} heartbeats in the second call")
    return see.failed(
        f"{len(got)} of {len(WAITING_WORDS)} waiting words and {len(beats)} heartbeats in the second call",
        "words that waited in the queue are handled, and the timers tick again",
        "The first call has destroyed the node or the executor, shut down ROS, or left a thread behind that "
        "takes the work.",
        "Do not destroy or shut down what you did not make. If you made an executor, end it in the same call.",
        about_time=True,
    )


@criterion(
    points=1, title="Slow callbacks do not carry it far beyond its time", needs=[returns_in_time, again]
)
def slow_callbacks(recording: Recording) -> Verdict:
    verdict = in_time(recording, SLOW, extra=JOB_S)
    if not verdict.ok:
        return verdict
    begun = done_in(recording, JOB_BEGUN.name, SLOW)
    if begun:
        return see.passed(f"{verdict.saw}, with {len(begun)} slow jobs begun")
    return see.failed(
        "none of the slow jobs was begun",
        "the jobs are begun one after the other, as far as the time reaches",
        "The queue of /robot/jobs was never looked at.",
        "Let rclpy.spin_once(node, timeout_sec=...) choose what to run.",
        about_time=True,
    )


@criterion(
    points=1, title="It comes back from a node that has almost nothing to do", needs=[returns_in_time, again]
)
def quiet_node(recording: Recording) -> Verdict:
    return in_time(recording, QUIET)


@criterion(points=1, title="It leaves the processor alone while it waits", needs=[returns])
def easy_on_the_processor(recording: Recording) -> Verdict:
    shares = {
        number: see.processor_share(recording, call.begin, call.end)
        for number, call in calls(recording).items()
        if number != SLOW and call.end is not None
    }
    share = max((one for one in shares.values() if one is not None), default=0.0)
    if share < PROCESSOR_SHARE:
        return see.passed(f"{share:.0%} of one processor")
    return see.failed(
        f"{share:.0%} of one processor, most of it for waiting",
        f"less than {PROCESSOR_SHARE:.0%}",
        "A loop with timeout_sec=0, or a very short one, hardly waits: it asks again and again whether there is work.",
        "Let spin_once wait, 0.05 s for example, but not longer than is left. It wakes up by itself when a callback is "
        "ready.",
    )


@criterion(points=1, title="When it is back, nothing goes on behind your back", needs=[returns])
def nothing_left_running(recording: Recording) -> Verdict:
    beats = done_in(recording, HEARTBEAT.name, 0)
    if len(beats) < 3:
        return see.passed("the node rests between the calls")
    return see.failed(
        f"{len(beats)} heartbeats between the calls",
        "no callback runs unless pump is called",
        "A thread that spins was left behind. It handles callbacks at moments that nobody expects, "
        "and may abort the process at its end.",
        "Spin in the thread that called pump. If you need another one: executor.shutdown(), then join().",
    )
