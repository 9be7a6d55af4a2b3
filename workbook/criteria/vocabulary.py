"""The small vocabulary of criteria: each word looks at a recording and answers with a verdict in plain sentences."""

import difflib
import math
import statistics
from collections.abc import Callable, Collection, Sequence
from typing import Any

from workbook.criteria.criterion import Topic
from workbook.criteria.estimators import Pace, pace
from workbook.criteria.garbled import why_garbled
from workbook.criteria.mishaps import find_mishap
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.observing.recording import Arrival, Recording, TopicRecording

RATE_TOLERANCE = 0.2
LONGEST_GAP_PERIODS = 1.5
INTERVAL_TOLERANCE = 0.1
LEAST_INTERVALS = 3


def number(value: float) -> str:
    """A number as a person would say it: 0.5, 12, 3.1416."""
    if not math.isfinite(value):
        return str(value)
    return f"{value:.4g}"


def hertz(value: float) -> str:
    """A measured rate, rounded to what can be told from a few messages: 0.5, 1.1, 100."""
    return f"{float(f'{value:.2g}'):g}"


def seconds(value: float) -> str:
    return f"{value:.1f} s"


def listing(names: Sequence[str]) -> str:
    """Names as an English list."""
    if len(names) < 2:
        return "".join(names)
    return ", ".join(names[:-1]) + " and " + names[-1]


def _count(n: int, noun: str) -> str:
    return f"{n} {noun}" if n == 1 else f"{n} {noun}s"


# --- the program as a whole ---------------------------------------------------------------------------------


def program_runs(recording: Recording) -> Verdict:
    """The program starts and its node or a publisher of it is seen on the graph."""
    expected = "a program that starts, makes its node and keeps it running"
    if _got_going(recording):
        nodes = sorted({node.name for node in recording.nodes})
        return passed(f"node {listing(nodes)} is on the graph" if nodes else "publishers are on the graph")
    process = recording.process
    strangers = [domain for domain in process.domains_used if domain != recording.domain_id]
    if strangers:
        return failed(
            f"your node is on domain {strangers[0]}, the exercise on another one",
            "a node on the domain that the environment gives (ROS_DOMAIN_ID)",
            "The program chooses a domain itself, so nobody here can hear it.",
            "Remove the domain_id argument or the ROS_DOMAIN_ID line from your program.",
        )
    if process.ended_by == "itself":
        return _ended_before_it_was_seen(recording, expected)
    if "output" in process.limits_hit:
        return failed(
            "the program printed more than 50 MB and was stopped",
            expected,
            "Something prints in an endless loop.",
            "Look for a print or log line that runs without a timer or a pause.",
        )
    if any(topic.publishers for topic in recording.topics.values()):
        return failed(
            "the publishers of your node appeared and vanished again, while the program runs on",
            expected,
            "The node was destroyed before it was spun (destroy_node, shutdown, or a with block that ended).",
            "Destroy the node only after rclpy.spin(node) has returned.",
        )
    if recording.nodes:
        names = listing(sorted(node.name for node in recording.nodes))
        return failed(
            f"node {names} is there, but it publishes nothing at all",
            expected,
            "No create_publisher() call was reached.",
            "Create the publishers in __init__ and make sure that __init__ runs to its end.",
        )
    return failed(
        f"the program runs, but no node of it appeared within {seconds(process.watched_for)}",
        expected,
        "It is still busy in its first lines (a loop, a sleep, a wait), or never makes a node.",
        "Make the node first, and let timers do the work that repeats.",
    )


def _got_going(recording: Recording) -> bool:
    """A message arrived, or a publisher is there and stays while the program runs.

    A program that fails in its first lines may show publishers for a moment; that is not yet running.
    """
    topics = recording.topics.values()
    if any(topic.arrivals or topic.undecodable or topic.not_kept for topic in topics):
        return True
    if recording.process.ended_by == "itself":
        return False
    return any(publisher.last_seen is None for topic in topics for publisher in topic.publishers)


def _ended_before_it_was_seen(recording: Recording, expected: str) -> Verdict:
    process = recording.process
    mishap = find_mishap(process.log, process.program)
    if mishap is not None:
        return failed(f"{mishap.where}{mishap.error}", expected, mishap.because, mishap.try_this)
    how = f"signal {process.signal}" if process.signal else f"exit code {process.exit}"
    return failed(
        f"the program ended after {seconds(process.ended_at or 0.0)} ({how}), before any message came",
        expected,
        "Nothing keeps it alive: a program ends with its last line unless something spins.",
        "Make the node in main(), call rclpy.spin(node), and call main() at the end of the file.",
    )


def alive_at_end(recording: Recording) -> Verdict:
    """The program still runs when the watch ends."""
    process = recording.process
    expected = "a program that goes on until it is stopped"
    if process.ended_by != "itself":
        return passed(f"still running after {seconds(process.watched_for)}")
    ended = f"the program ended by itself after {seconds(process.ended_at or 0.0)}"
    mishap = find_mishap(process.log, process.program)
    if mishap is not None:
        return failed(f"{ended}: {mishap.where}{mishap.error}", expected, mishap.because, mishap.try_this)
    how = f"signal {process.signal}" if process.signal else f"exit code {process.exit}"
    return failed(
        f"{ended} ({how})",
        expected,
        "A loop that counts, a spin with an end, or a missing rclpy.spin(node).",
        "Keep the node alive with rclpy.spin(node) until Ctrl-C.",
    )


def exits_cleanly(recording: Recording) -> Verdict:
    """On Ctrl-C (SIGINT) the program ends with exit code 0 and without a traceback.

    Needs `watching(to_the_end=True)`; raises ValueError when the recording does not hold the end.
    """
    process = recording.process
    if process.ended_by is None:
        raise ValueError("exits_cleanly needs watching(to_the_end=True) in the criteria file")
    expected = "exit code 0 and no traceback after Ctrl-C"
    if process.ended_by == "itself":
        return failed(
            f"the program ended by itself after {seconds(process.ended_at or 0.0)}, before Ctrl-C was sent",
            expected,
            "Nothing keeps it alive, or an error ended it.",
            "Keep it running with rclpy.spin(node) first.",
        )
    if process.signal == "SIGKILL":
        return failed(
            "it went on running after Ctrl-C and had to be killed",
            expected,
            "KeyboardInterrupt is swallowed inside a loop, or a thread goes on.",
            "Let KeyboardInterrupt leave the spin; catch it around rclpy.spin(node) only.",
        )
    if process.signal == "SIGABRT":
        return failed(
            "it aborted at its end (SIGABRT)",
            expected,
            "A thread was still spinning when the interpreter went down.",
            "Shut the executor down first, then join its thread.",
        )
    mishap = find_mishap(process.end_log, process.program)
    if mishap is None and process.exit == 0:
        return passed("ended with exit code 0 after Ctrl-C, no traceback")
    if mishap is not None:
        return failed(
            f"after Ctrl-C: {mishap.where}{mishap.error} (exit code {process.exit})",
            expected,
            mishap.because,
            mishap.try_this,
        )
    return failed(
        f"exit code {process.exit} after Ctrl-C",
        expected,
        "KeyboardInterrupt leaves main() without being caught.",
        "Wrap rclpy.spin(node) in try/except (KeyboardInterrupt, ExternalShutdownException), and call "
        "rclpy.try_shutdown() in finally.",
    )


# --- topics -------------------------------------------------------------------------------------------------


def publishes(recording: Recording, topic: Topic) -> Verdict:
    """Somebody publishes `topic` with the right type."""
    seen = recording.topic(topic.name)
    expected = f"a publisher on {topic.name} of type {topic.short_type}"
    if topic.type in seen.types:
        others = [name for name in seen.types if name != topic.type]
        if others:
            return failed(
                f"{topic.name} has publishers of two types: {topic.short_type} and {listing(others)}",
                expected,
                "Two create_publisher() calls use the same topic name with different message types.",
                "Keep the one of the right type.",
            )
        return passed(f"{topic.name} carries {topic.short_type}")
    if seen.publishers:
        got = listing([name.rsplit("/", 1)[1] for name in seen.types])
        return failed(
            f"{topic.name} carries {got}",
            expected,
            f"The publisher was created with another message type than {topic.short_type}.",
            f"Import {topic.short_type} from {topic.type.split('/')[0]}.msg and give it to create_publisher().",
        )
    return _not_published(recording, topic, expected)


def _not_published(recording: Recording, topic: Topic, expected: str) -> Verdict:
    names = [other.name for other in recording.published()]
    same_type = [
        other for other in recording.published() if topic.type in other.types and other.name != topic.name
    ]
    near = difflib.get_close_matches(topic.name, names, 1, 0.75)
    base = topic.name.rsplit("/", 1)[-1]
    suspect = next((name for name in names if name.rsplit("/", 1)[-1] == base), near[0] if near else None)
    if suspect is None and len(same_type) == 1 and similar_share(same_type[0].name, topic.name) > 0.5:
        suspect = same_type[0].name
    if suspect is not None:
        return failed(
            f"your node publishes {suspect}, and nothing on {topic.name}",
            expected,
            _why_other_name(recording, suspect, topic.name),
            f"Write the name as {topic.name!r}.",
        )
    mishap = find_mishap(recording.process.log, recording.process.program)
    if mishap is not None:
        return failed(
            f"nothing on {topic.name}: {mishap.where}{mishap.error}",
            expected,
            mishap.because,
            mishap.try_this,
        )
    return failed(
        f"nothing on {topic.name}; your program publishes {listing(names) or 'nothing'}",
        expected,
        "The publisher is not created, or under a very different name.",
        f"Call create_publisher({topic.short_type}, {topic.name!r}, 10) in __init__.",
    )


def similar_share(one: str, other: str) -> float:
    """How alike two names are, 0 to 1."""
    return difflib.SequenceMatcher(None, one, other).ratio()


def _why_other_name(recording: Recording, seen: str, wanted: str) -> str:
    if seen.lower() == wanted.lower():
        return "Topic names are case-sensitive: capital and small letters are different names."
    owners = {publisher.node for publisher in recording.topic(seen).publishers}
    if any(seen.startswith(f"{owner}/") for owner in owners):
        return "A name that begins with ~ is private: the node's own name is put in front."
    if wanted.endswith(seen):
        return f"The namespace {wanted[: -len(seen)]} is missing."
    if seen.endswith(wanted):
        return f"The node runs in the namespace {seen[: -len(wanted)]}, which is put in front of a relative name."
    return "The two names differ; ROS matches names letter by letter."


def _arrivals(recording: Recording, topic: Topic) -> list[Arrival]:
    return list(recording.topic(topic.name).arrivals)


def no_message(recording: Recording, topic: Topic) -> Verdict | None:
    """A failed verdict when nothing arrived on `topic`, else None."""
    seen = recording.topic(topic.name)
    if seen.arrivals:
        return None
    window = _window(recording, seen)
    lasted = seconds(window[1] - window[0])
    if seen.undecodable:
        return failed(
            f"{_count(seen.undecodable, 'message')} on {topic.name} could not be decoded",
            f"readable {topic.short_type} messages",
            "The bytes on the wire are no message of this type.",
            "Publish message objects, not raw bytes.",
        )
    mishap = find_mishap(recording.process.log, recording.process.program)
    if mishap is not None:
        return failed(
            f"no message on {topic.name} in {lasted}: {mishap.where}{mishap.error}",
            f"messages on {topic.name}",
            mishap.because,
            mishap.try_this,
            about_time=True,
        )
    return failed(
        f"the publisher on {topic.name} is there, but no message arrived in {lasted}",
        f"messages on {topic.name}",
        "No timer calls the function that publishes, the node does not spin, or it published only once before "
        "anybody was connected.",
        "Create a timer for it in __init__, keep it running with rclpy.spin(node), and publish inside the callback.",
        about_time=True,
    )


def _window(recording: Recording, seen: TopicRecording) -> tuple[float, float]:
    start, end = seen.window if seen.window is not None else (0.0, recording.robot_s)
    return start, max(start, end)


def topic_pace(recording: Recording, topic: Topic) -> Pace:
    """How the messages of `topic` are spread over its window, in robot time."""
    seen = recording.topic(topic.name)
    start, end = _window(recording, seen)
    return pace([arrival.t for arrival in seen.arrivals], start, end, topic.period)


def rate(recording: Recording, topic: Topic) -> Verdict:
    """Messages come at the topic's rate: mean within 20 %, no silence longer than one and a half periods."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    assert topic.hz is not None
    seen = topic_pace(recording, topic)
    window = _window(recording, recording.topic(topic.name))
    low, high = topic.hz * (1 - RATE_TOLERANCE), topic.hz * (1 + RATE_TOLERANCE)
    expected = (
        f"{number(topic.hz)} Hz: one message every {number(topic.period)} s "
        f"({number(low)} to {number(high)} Hz, no gap over {number(LONGEST_GAP_PERIODS * topic.period)} s)"
    )

    def fail(saw: str, because: str, try_this: str) -> Verdict:
        return failed(saw, expected, because, try_this, about_time=True)

    if seen.hz is None:
        once = (
            "one single message" if seen.count == 1 else f"{seen.count} messages at one moment, and no other"
        )
        return fail(
            f"{once} in {seconds(window[1] - window[0])}",
            "It is published once, or far too rarely.",
            f"Publish in a callback and let create_timer({number(topic.period)}, ...) call it.",
        )
    gap_limit = LONGEST_GAP_PERIODS * topic.period
    hz = seen.hz
    if seen.in_bursts and hz > high:
        groups = "pairs" if seen.burst == 2 else f"groups of {seen.burst}"
        return fail(
            f"{hertz(hz)} Hz: messages come in {groups}",
            "Two timers call the same function, two publishers share the topic, or one callback publishes twice.",
            "Keep one timer and one publish() for this topic.",
        )
    if seen.gap.kind == "after" and seen.gap.seconds > gap_limit:
        return fail(
            f"the last of {_count(seen.count, 'message')} came at {seconds(seen.gap.start)}, "
            f"then nothing until {seconds(seen.gap.end)}",
            "The publishing stops: a counter runs out, an exception ends the callback, or the program has ended.",
            "Publish on every tick of the timer and look into the log for an error.",
        )
    if not low <= hz <= high:
        return fail(_rate_seen(recording, seen, hz), _why_rate(topic, hz), _try_rate(topic))
    if seen.gap.seconds > gap_limit + (recording.step_s or 0.0):
        where = (
            "before the first message" if seen.gap.kind == "before" else f"after {seconds(seen.gap.start)}"
        )
        return fail(
            f"a silence of {seconds(seen.gap.seconds)} {where}",
            "Something blocks: while one callback works or sleeps, no other timer of the node runs.",
            "Keep callbacks short; never sleep in one.",
        )
    if seen.count <= LEAST_INTERVALS:
        return fail(
            f"only {_count(seen.count, 'message')} in {seconds(window[1] - window[0])}",
            "Too few to tell a rate.",
            f"Let create_timer({number(topic.period)}, ...) call the function that publishes.",
        )
    return passed(f"{hertz(hz)} Hz over {_count(seen.count, 'message')}")


def counts(recording: Recording, topic: Topic) -> Verdict:
    """Exactly as many messages as periods in the window; one more or less may fall on its edge."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    assert topic.hz is not None
    seen = topic_pace(recording, topic)
    start, end = _window(recording, recording.topic(topic.name))
    wanted = round((end - start) * topic.hz)
    if abs(seen.count - wanted) <= 1:
        return passed(f"{seen.count} messages in {seconds(end - start)}")
    hz = seen.count / (end - start)
    return failed(
        f"{_count(seen.count, 'message')} in {seconds(end - start)} ({hertz(hz)} Hz)",
        f"{wanted} messages: {number(topic.hz)} Hz, one every {number(topic.period)} s",
        _why_rate(topic, hz),
        _try_rate(topic),
        about_time=True,
    )


def keeps_period(recording: Recording, topic: Topic) -> Verdict:
    """The typical interval is the topic's period, within a tenth: exact also where few messages were watched."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    typical = topic_pace(recording, topic).typical_interval
    if typical is not None and abs(typical - topic.period) <= INTERVAL_TOLERANCE * topic.period:
        return passed(f"one message every {number(topic.period)} s")
    return failed(
        "one single message"
        if typical is None
        else f"typically {typical:.3g} s from one message to the next",
        f"one message every {number(topic.period)} s",
        "It is published once, not again and again."
        if typical is None
        else "The period given to create_timer is near the right one, but not the right one; or a loop sleeps for the "
        "period and takes the time of its work on top.",
        _try_rate(topic),
        about_time=True,
    )


def _rate_seen(recording: Recording, seen: Pace, hz: float) -> str:
    if recording.step_s is not None and hz > 0.5 / recording.step_s:
        return f"faster than {number(0.5 / recording.step_s)} Hz"
    return f"{hertz(hz)} Hz: one message every {hertz(1 / hz)} s ({_count(seen.count, 'message')})"


def _why_rate(topic: Topic, hz: float) -> str:
    assert topic.hz is not None
    if topic.hz != 1.0 and math.isclose(hz, 1 / topic.hz, rel_tol=0.15):
        return (
            f"Period and frequency are mixed up: create_timer takes seconds, and {number(topic.hz)} as a period "
            f"means {number(1 / topic.hz)} Hz."
        )
    if hz > topic.hz:
        times = hz / topic.hz
        return f"That is {number(times)} times too fast: the period given to create_timer is too short."
    return "Too slow: the period is too long, or a slow callback holds up the timer."


def _try_rate(topic: Topic) -> str:
    return f"{number(topic.hz or 0.0)} Hz is a period of {number(topic.period)} s: create_timer({topic.period}, ...)."


# --- values -------------------------------------------------------------------------------------------------


def values(recording: Recording, topic: Topic, field: str = "data") -> list[Any]:
    """The values of one field of all messages that arrived."""
    return [
        arrival.value.get(field) for arrival in _arrivals(recording, topic) if isinstance(arrival.value, dict)
    ]


def _array(value: Any) -> list[Any]:
    if isinstance(value, dict) and "first" in value:
        return list(value["first"])
    return value if isinstance(value, list) else [value]


def _array_length(value: Any) -> int:
    if isinstance(value, dict) and "length" in value:
        return int(value["length"])
    return len(_array(value))


def length(recording: Recording, topic: Topic, wanted: int, what: str = "value") -> Verdict:
    """Every message carries an array of exactly `wanted` elements."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    lengths = [_array_length(value) for value in values(recording, topic)]
    wrong = [n for n in lengths if n != wanted]
    if not wrong:
        return passed(f"{_count(wanted, what)} in each of {_count(len(lengths), 'message')}")
    kinds = listing([str(n) for n in sorted(set(wrong))])
    how_many = (
        "every message has" if len(wrong) == len(lengths) else f"{len(wrong)} of {len(lengths)} messages have"
    )
    reason = "Counting from 0 or from 1 gets one too many or one too few easily."
    if 0 in wrong:
        reason = "At least one message was published before its data was filled in."
    elif all(abs(n - wanted) > 1 for n in wrong):
        reason = "The list is built from something else than the joints, or grows with every message."
    return failed(
        f"{how_many} {kinds} {what}s",
        f"exactly {_count(wanted, what)} in every message",
        reason,
        f"Print len(msg.data) before you publish; it must say {wanted}.",
    )


def _first_bad(
    recording: Recording, topic: Topic, bad: Callable[[Any], bool]
) -> tuple[int, int | None, Any, int] | None:
    """First offending value: message number, place in the array (None for a scalar), value, messages affected."""
    first: tuple[int, int | None, Any] | None = None
    affected = 0
    for index, value in enumerate(values(recording, topic)):
        elements = _array(value)
        places = [place for place, element in enumerate(elements) if bad(element)]
        if places:
            affected += 1
            if first is None:
                place = None if not isinstance(value, (list, dict)) else places[0]
                first = (index + 1, place, elements[places[0]])
    return None if first is None else (*first, affected)


def _place(message: int, place: int | None) -> str:
    return f"message {message}" if place is None else f"message {message}, element {place}"


def finite(recording: Recording, topic: Topic) -> Verdict:
    """No value is NaN or infinite."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    bad = _first_bad(recording, topic, lambda x: not (isinstance(x, (int, float)) and math.isfinite(x)))
    if bad is None:
        return passed("all values finite")
    message, place, value, affected = bad
    return failed(
        f"{value} in {_place(message, place)} ({_count(affected, 'message')} affected)",
        "finite numbers only",
        "A division by zero, a square root or logarithm of a negative number, or a start value of NaN. "
        "A motor that receives NaN may do anything.",
        "Check with math.isfinite() before you publish.",
    )


def really_arrives(recording: Recording, topic: Topic) -> Verdict:
    """No message says 0.0 where the program means another number: not the first one, and none before another number.

    For a quantity that starts above zero and never comes back from it, such as a charge. What fails here is mostly a
    value that is no Python float: stock ROS sends it as 0.0.
    """
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    seen = [value for value in values(recording, topic) if isinstance(value, (int, float))]
    zeros = [place for place, value in enumerate(seen) if value == 0.0]
    followed = [place for place in zeros if any(value != 0.0 for value in seen[place:])]
    if not followed and (not seen or seen[0] != 0.0):
        return passed(
            f"numbers arrive as they are, the first is {number(seen[0])}" if seen else "no numbers in it"
        )
    if len(zeros) == len(seen):
        saw = f"0.0 on {topic.name} in each of {_count(len(seen), 'message')}, from the first on"
    else:
        after = next(value for value in seen[followed[0] :] if value != 0.0)
        saw = f"0.0 on {topic.name} in message {followed[0] + 1}, and {number(after)} after it"
    return failed(
        saw,
        "the number that your program means, in every message",
        why_garbled(
            recording,
            "Stock ROS does not check what a field is given. In a float field an int is sent as 0.0, without a word; "
            "so are a str, None and np.float32.",
            "The program itself says 0.0: with field checks on, nothing of a wrong type was found in its messages.",
        ),
        "Give the field a float: float(level), 100.0 and not 100, and no int() or round() on the way.",
        garbled=True,
    )


def within(
    recording: Recording, topic: Topic, low: float, high: float, unit: str = "", slack: float = 1e-6
) -> Verdict:
    """Every value lies in [low, high]; `slack` allows for rounding to 32 bits. NaN is `finite`'s business."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    unit = f" {unit}" if unit else ""
    span = f"{number(low)} to {number(high)}{unit}"
    bad = _first_bad(
        recording,
        topic,
        lambda x: isinstance(x, (int, float)) and not low - slack <= x <= high + slack and x == x,
    )
    if bad is None:
        return passed(f"all values within {span}")
    message, place, value, affected = bad
    reason = "The simulated value is not limited."
    if math.isclose(high, math.pi) and abs(value) <= 2 * math.pi:
        reason = "The angle goes on turning: it is neither limited nor wrapped at π."
    elif math.isclose(high, math.pi) and abs(value) <= 360.0:
        reason = "Values above π look like degrees; angles in ROS are radians (REP 103)."
    elif math.isinf(value):
        reason = "Infinite: a division by zero, or a number too large for 32 bits."
    return failed(
        f"{number(value)}{unit} in {_place(message, place)} ({_count(affected, 'message')} affected)",
        f"values from {span}",
        reason,
        f"Limit it: max({number(low)}, min({number(high)}, value))"
        + ("; math.radians() turns degrees into radians." if "degrees" in reason else "."),
    )


def varies(recording: Recording, topic: Topic, at_least: int, by: float, what: str = "value") -> Verdict:
    """At least `at_least` elements of the array change by more than `by` over the recording."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    rows = [_array(value) for value in values(recording, topic)]
    width = statistics.mode(len(row) for row in rows)
    rows = [row for row in rows if len(row) == width]
    moving = []
    for place in range(width):
        column = [
            row[place] for row in rows if isinstance(row[place], (int, float)) and math.isfinite(row[place])
        ]
        if column and max(column) - min(column) > by:
            moving.append(place)
    if len(moving) >= at_least:
        return passed(f"{len(moving)} of {width} {what}s move")
    saw = f"only {what} {moving[0]} moves" if moving else f"no {what} moves: every message is the same"
    reason = (
        "The values are set once, outside the callback."
        if not moving
        else "Only one element is ever changed."
    )
    if len(rows) < 2:
        saw, reason = (
            "a single message, so nothing can be seen to move",
            "The message is published only once.",
        )
    return failed(
        saw,
        f"at least {_count(at_least, what)} that change from message to message (by more than {by:g})",
        reason,
        "Compute new angles in the timer callback, for example from math.sin of a counter.",
        about_time=len(rows) < LEAST_INTERVALS,
    )


def one_of(recording: Recording, topic: Topic, allowed: Collection[str]) -> Verdict:
    """Every text is one of the allowed words."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    words = listing([f'"{word}"' for word in sorted(allowed, reverse=True)]).replace(" and ", " or ")
    wrong = [
        value for value in values(recording, topic) if not isinstance(value, str) or value not in allowed
    ]
    if not wrong:
        said = sorted(set(map(str, values(recording, topic))))
        return passed("it says " + listing([f'"{word}"' for word in said]))
    text = str(wrong[0])[:60]
    reason = "Others compare this text letter by letter."
    if text == "":
        reason = (
            "Empty text: the message was published before its data was set, or a field name is misspelled."
        )
        reason = why_garbled(recording, reason, reason)
    return failed(
        f'"{text}" on {topic.name}', words, reason, f"Publish exactly one of {words}.", garbled=text == ""
    )


def never_rises(recording: Recording, topic: Topic, slack: float = 1e-4) -> Verdict:
    """No value is larger than the one before it (`slack` for rounding)."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    numbers = [value for value in values(recording, topic) if isinstance(value, (int, float))]
    for index, (before, after) in enumerate(zip(numbers, numbers[1:], strict=False)):
        if after > before + slack:
            return failed(
                f"{topic.name} rises from {number(before)} to {number(after)} at message {index + 2}",
                "a value that only falls",
                "The sign of the drain is wrong, or each message starts from a fresh random number.",
                "Subtract from the level that the node remembers.",
            )
    return passed(
        f"falls from {number(numbers[0])} to {number(numbers[-1])}" if len(numbers) > 1 else "never rises"
    )
