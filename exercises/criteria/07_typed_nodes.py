"""How exercise 07 is judged: mypy reads the node and code that uses it, and a driver uses it while it runs.

Which numbers the driver sends, and in which order it makes its calls, is drawn for each run.
"""

import re
from collections import Counter
from dataclasses import replace
from random import Random

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import Recording, Topic, Verdict, criterion, probe, program_runs, topic, watching

BATTERY = topic("/robot/battery", Float32, hz=1.0)
STATUS = topic("/robot/status", String, hz=0.5)
REPORT = topic("/driver/report", String, signed=True)
# What would become of a wrong call, if it were sent; the node itself sends other values.
WRONG_LEVELS = (87.5, 50.0, 12.5)
NEVER_SENT = (
    "operatoinal", "3", "None", "Error", " error", "error\n", "oper", "error: arm", "charging", "",
)  # fmt: skip
DROPPED = (
    "The value is dropped without an error: by return, pass, or only a line in the log. The caller believes that it "
    "was sent."
)
ZERO_SENT = f"0.0 was sent on {BATTERY.name}"
ROUNDING = 1e-4  # how near an arrived number is to a rounded one
ZERO = "send_battery(0.0)"
NEAR = 1.0  # how far (%) a node may drain until it reports by itself again
NUMBER_CALL = re.compile(r"(?:send_battery\(|battery_publisher\.publish\(Float32\(data=)(\d+(?:\.\d+)?)\)+")
GOOD_WORD = "send_status('error')"
GOOD_MESSAGE = "status_publisher.publish(String(data='error'))"
READ_AS_NUMBERS = ("send_battery('87.5')", "send_battery(b'87.5')")  # float() accepts both
NO_NUMBER = "send_battery(None)"
WRONG_NUMBERS = (
    "send_battery('full')",
    *READ_AS_NUMBERS,
    NO_NUMBER,
    "send_battery([50.0])",
    "send_battery((50.0,))",
)
NO_TEXTS = ("send_status(3)", "send_status(None)", "send_status(b'error')", "send_status(Path('error'))")
WRONG_WORDS = (
    "send_status('operatoinal')",
    *NO_TEXTS,
    "send_status('Error')",
    "send_status(' error')",
    "send_status('error\\n')",
    "send_status('oper')",
    "send_status('error: arm')",
    "send_status('charging')",
    "send_status('')",
)
NO_MESSAGES = (
    "battery_publisher.publish(12.5)",
    "status_publisher.publish('oper')",
    "battery_publisher.publish(None)",
    "status_publisher.publish(None)",
)
WRONG_MESSAGES = (
    "battery_publisher.publish(String())",
    "battery_publisher.publish(Float64(data=12.5))",
    "status_publisher.publish(Float32())",
    *NO_MESSAGES,
)


def drawn_calls(rng: Random, numbers: list[str], twice: str) -> str:
    """All calls of one order, a line for each: a number twice in a row, after all others.

    Of what is no word of the status, a text comes first: a check that refuses only once shows.
    """
    calls = [*numbers, GOOD_WORD, GOOD_MESSAGE, *WRONG_NUMBERS, *WRONG_WORDS, *WRONG_MESSAGES]
    while True:
        rng.shuffle(calls)
        if next(call for call in calls if call in WRONG_WORDS) not in NO_TEXTS:
            break
    after = 1 + max(calls.index(call) for call in numbers if call.startswith("send_battery"))
    place = rng.randint(after, len(calls))
    return "\n".join([*calls[:place], twice, twice, *calls[place:]])


def drawn(rng: Random) -> list[see.Part]:
    """One order in each half of the watch, with the same calls."""
    levels = (
        f"{rng.randrange(21, 80, 2)}",
        f"{rng.randint(21, 79)}.25",
        "0.0",
        f"{rng.randrange(5, 29, 2) / 32}",
        f"{rng.randint(21, 79) + rng.randrange(1, 64, 2) / 64}",
        rng.choice(("99.9375", "99.8125")),  # more than the node's own
    )
    numbers = [f"send_battery({level})" for level in levels]
    numbers.append(f"battery_publisher.publish(Float32(data={rng.randint(21, 79)}.75))")
    twice = f"send_battery({rng.randint(51, 79)}.5)"
    orders = [(at, drawn_calls(rng, numbers, twice)) for at in (2.6, 8.6)]
    return [see.publish("/driver/go", String, orders)]


WATCH = watching(simulated_seconds=12, script=drawn)

RIGHT_USE = probe(
    "correct use of your node",
    """
    from answer import RobotReport
    from std_msgs.msg import Float32, String

    def use(robot: RobotReport) -> None:
        robot.send_battery(55.25)
        robot.send_battery(42)
        robot.send_battery(0.0)
        robot.send_status("error")
        robot.send_status("operational")
        robot.battery_publisher.publish(Float32(data=55.25))
        robot.status_publisher.publish(String(data="operational"))
    """,
)
WRONG_MESSAGE = probe(
    "a message of the wrong type",
    """
    from answer import RobotReport
    from std_msgs.msg import Bool, Char, Float32, Float64, Int32, String

    def use(robot: RobotReport) -> None:
        robot.battery_publisher.publish(Float32(data=55.25))
        robot.status_publisher.publish(String(data="operational"))
        robot.battery_publisher.publish(String(data="full"))  # wrong
        robot.status_publisher.publish(Float32(data=55.25))  # wrong
        robot.battery_publisher.publish(55.25)  # wrong
        robot.status_publisher.publish("operational")  # wrong
        robot.battery_publisher.publish(None)  # wrong
        robot.status_publisher.publish(None)  # wrong
        robot.battery_publisher.publish(b"full")  # wrong
        robot.status_publisher.publish(b"operational")  # wrong
        robot.battery_publisher.publish(Float64(data=55.25))  # wrong
        robot.battery_publisher.publish(Int32(data=55))  # wrong
        robot.status_publisher.publish(Bool(data=True))  # wrong
        robot.status_publisher.publish(Char(data=111))  # wrong
    """,
)
WRONG_VALUE = probe(
    "a value of the wrong type",
    """
    from answer import RobotReport
    from std_msgs.msg import Float32

    def use(robot: RobotReport) -> None:
        robot.send_battery(55.25)
        robot.send_status("error")
        robot.send_battery("full")  # wrong
        robot.send_battery(None)  # wrong
        robot.send_battery([50.0])  # wrong
        robot.send_battery(1j)  # wrong
        robot.send_battery(b"87.5")  # wrong
        robot.send_battery(Float32(data=50.0))  # wrong
        robot.send_status("operatoinal")  # wrong
        robot.send_status(3)  # wrong
        robot.send_status(None)  # wrong
        robot.send_status(b"error")  # wrong
        robot.send_status("Error")  # wrong
        robot.send_status("charging")  # wrong
        robot.send_status("warning")  # wrong
        robot.send_status("unknown")  # wrong
        robot.send_status("ok")  # wrong
        robot.send_status("idle")  # wrong
        robot.send_status("ready")  # wrong
        robot.send_status("busy")  # wrong
        robot.send_status("standby")  # wrong
        robot.send_status("low")  # wrong
        robot.send_status("low battery")  # wrong
        robot.send_status("low_battery")  # wrong
        robot.send_status("empty")  # wrong
        robot.send_status("degraded")  # wrong
        robot.send_status("maintenance")  # wrong
        robot.send_status("fault")  # wrong
        robot.send_status("failed")  # wrong
        robot.send_status("stopped")  # wrong
        robot.send_status("offline")  # wrong
        robot.send_status("emergency")  # wrong
        robot.send_status("OPERATIONAL")  # wrong
        robot.send_status("ERROR")  # wrong
        robot.send_status("")  # wrong
    """,
)
NO_VALUE = probe(
    "a call without a value",
    """
    from answer import RobotReport

    def use(robot: RobotReport) -> None:
        robot.send_battery(55.25)
        robot.send_status("error")
        robot.send_battery()  # wrong
        robot.send_status()  # wrong
    """,
)


@criterion(
    points=1,
    title="The node reports as before: the battery at 1 Hz, the status at 0.5 Hz",
    needs=[program_runs],
)
def reports_as_before(recording: Recording) -> Verdict:
    own = by_itself(recording)
    return (
        level_replaced(recording, own)
        or error_kept(recording, own)
        or see.all_of(
            see.publishes(own, BATTERY),
            see.publishes(own, STATUS),
            see.rate(own, BATTERY),
            see.rate(own, STATUS),
            see.within(own, BATTERY, 0.0, 100.0, "%"),
            see.one_of(own, STATUS, {"operational", "error"}),
            see.drains(own, BATTERY),
            see.word_fits_charge(own, STATUS, BATTERY),
        )
    )


def level_replaced(recording: Recording, own: Recording) -> Verdict | None:
    """Whether the node goes on with the number that the driver sent last, each time."""
    twice = called_twice(recording)
    told = number_calls(recording).get(twice, 0.0)
    own_values = [(one.published, one.value["data"]) for one in own.topic(BATTERY.name).arrivals]
    pairs = []
    for order in see.published(recording, "/driver/go"):
        before = [value for at, value in own_values if at < order.wall]
        after = [value for at, value in own_values if at >= order.wall]
        if not before or not after:
            return None
        pairs.append((before[-1], after[0]))
    if (
        not pairs
        or abs(pairs[0][0] - told) <= NEAR
        or any(not 0.0 <= told - after <= NEAR for _, after in pairs)
    ):
        return None
    return see.failed(
        "reports-as-before.level-replaced",
        f"{see.number(pairs[0][0])} % before others sent charges, and {see.number(pairs[0][1])} % after {twice}",
        "the charge of the node itself, as if nothing had been sent",
        "send_battery changes the charge that the node itself drains and reports.",
        "Publish the level that is given, and leave self.level as it is.",
    )


def error_kept(recording: Recording, own: Recording) -> Verdict | None:
    """Whether the node itself says "error" from the driver's first calls on, although its battery has charge."""
    first = min((order.wall for order in see.published(recording, "/driver/go")), default=None)
    words = [(one.published, one.value["data"]) for one in own.topic(STATUS.name).arrivals]
    if first is None or 0.0 in see.values(own, BATTERY):
        return None
    before = {word for at, word in words if at < first}
    after = {word for at, word in words if at >= first}
    if before != {"operational"} or after != {"error"}:
        return None
    return see.failed(
        "reports-as-before.error-kept",
        f'"operational" before others sent a word, and only "error" after {GOOD_WORD}',
        "the word that fits the charge of the node itself, as if nothing had been sent",
        "send_status changes the word that the node itself reports.",
        "Publish the word that is given, and choose your own word by self.level alone.",
    )


@criterion(points=2, title="mypy --strict finds nothing in your program", needs=[program_runs])
def clean(recording: Recording) -> Verdict:
    return see.mypy_clean(recording)


@criterion(points=0, title="mypy accepts correct use of your node", needs=[program_runs])
def right_use(recording: Recording) -> Verdict:
    return see.mypy_accepts(recording, RIGHT_USE)


@criterion(
    points=2, title="mypy objects when a publisher gets a message of the wrong type", needs=[right_use]
)
def wrong_message_found(recording: Recording) -> Verdict:
    return see.mypy_objects(
        recording,
        WRONG_MESSAGE,
        cause="wrong-message-found.publisher-takes-any",
        because="The hint of this attribute allows more than messages of its one type. Any, object and rclpy's own "
        "Publisher, which does not know its message type, even allow everything.",
        try_this="Annotate the attributes with a Protocol that has a publish method for one type: "
        "self.battery_publisher: Sends[Float32] = ...",
    )


@criterion(points=1, title="mypy objects to a wrong value and to a misspelled word", needs=[right_use])
def wrong_value_found(recording: Recording) -> Verdict:
    return see.all_of(
        see.mypy_objects(
            recording,
            WRONG_VALUE,
            cause="wrong-value-found.hint-too-wide",
            because="The hint of this argument allows more than the robot can use, or there is no hint.",
            try_this='Write float for the level, and Literal["operational", "error"] for the word.',
        ),
        see.mypy_objects(
            recording,
            NO_VALUE,
            cause="wrong-value-found.default",
            because="The argument has a default. A caller who forgets the value sends that one without noticing.",
            try_this="Remove the default value: each call must say what it sends.",
        ),
    )


@criterion(
    points=1,
    title="Every number arrives unchanged, even a whole number or a repeated one",
    needs=[program_runs],
)
def numbers_arrive(recording: Recording) -> Verdict:
    if not outcomes(recording):
        return never_called()
    made = number_calls(recording)
    for call, number in made.items():
        verdict = why_refused(recording, call) or why_not_arrived(recording, call, number)
        if verdict is not None:
            return verdict
    return see.passed(f"{see.count(len(made), 'number')} arrived, 0.0 as 0.0, and one twice for two calls")


@criterion(
    points=2,
    title="At run time, too, a wrong value or message raises an exception, and nothing is published",
    needs=[program_runs],
)
def refuses_wrong_types(recording: Recording) -> Verdict:
    if not outcomes(recording):
        return never_called()
    numbers, messages = refuses_wrong_numbers(recording), refuses_wrong_messages(recording)
    if first_accepted(recording, WRONG_NUMBERS) is None and not messages.ok:
        return messages  # what was sent may have come from a message
    return see.all_of(numbers, messages)


@criterion(
    points=1,
    title="At run time, too, the two words are published, and any other raises an exception",
    needs=[program_runs],
)
def refuses_wrong_words(recording: Recording) -> Verdict:
    if not outcomes(recording):
        return never_called()
    return see.all_of(other_words_refused(recording), good_word_sent(recording))


def other_words_refused(recording: Recording) -> Verdict:
    """A call with any other word raises an error, and sends nothing."""
    wrong = sent_among(recording, STATUS, NEVER_SENT)
    accepted = first_accepted(recording, WRONG_WORDS)
    wrong.sort(key=lambda word: repr(word) not in (accepted or ""))
    sent = f"{wrong[0]!r} was sent on /robot/status" if wrong else ""
    if accepted is None:
        return refused(recording, WRONG_WORDS, sent or error_sent_for_others(recording))
    saw, expected = raised_nothing(accepted, sent), errors_expected(WRONG_WORDS)
    texts = set(WRONG_WORDS) - set(NO_TEXTS)
    if any(call in texts and what != "returned" for call, what in calls_made(recording)):
        return see.failed(
            "refuses-wrong-words.check-too-loose",
            saw,
            expected,
            "Your check refuses some words, but not this one. It is too loose (str(), lower(), strip(), startswith(), "
            "or `in` with a text), or it is skipped for some calls.",
            "In every call, before publishing: if word not in get_args(Status): raise ValueError(...)",
        )
    if not wrong:
        return see.failed(
            "refuses-wrong-words.dropped", saw, expected, DROPPED, "Raise ValueError for any other word."
        )
    return see.failed(
        "refuses-wrong-words.accepted",
        saw,
        expected,
        "A Literal is a hint like any other: at run time it stops nothing. A word may come from a file or a "
        "network, which mypy never sees.",
        "Before publishing: if word not in get_args(Status): raise ValueError(...)",
    )


def error_sent_for_others(recording: Recording) -> str:
    """In words, that "error" went out more often than it was asked for; empty if it did not, or twice each time."""
    if "error" in see.values(by_itself(recording), STATUS):
        return ""
    asked = times_done(recording, GOOD_WORD) + times_done(recording, GOOD_MESSAGE)
    sent = see.values(recording, STATUS).count("error")
    return '"error" was sent on /robot/status' if sent > asked and sent != 2 * asked else ""


def good_word_sent(recording: Recording) -> Verdict:
    """A call with one of the two words sends it."""
    what, expected = outcomes(recording).get(GOOD_WORD), f'"error" on {STATUS.name} after {GOOD_WORD}'
    if what != "returned":
        return see.failed(
            "refuses-wrong-words.good-word-refused",
            f"{GOOD_WORD} raised {what}",
            expected,
            'The check refuses "error", which is one of the two words.',
            "Compare with get_args(Status): so hint and check cannot differ.",
        )
    if "error" not in see.values(recording, STATUS):
        return see.failed(
            "refuses-wrong-words.good-word-lost",
            f'{GOOD_WORD} returned, but "error" never arrived on {STATUS.name}',
            expected,
            "The word is dropped or replaced, or sent on another topic.",
            "Publish the word that was given, on the topic of the status.",
        )
    return good_message_lost(recording) or see.passed(f"{GOOD_WORD} sends it")


def good_message_lost(recording: Recording) -> Verdict | None:
    """A failed verdict if the publisher of the status refuses a right message, or does not send it."""
    what = outcomes(recording).get(GOOD_MESSAGE, "returned")
    expected = f'"error" on {STATUS.name} after {GOOD_MESSAGE}'
    if what.startswith("AttributeError"):
        return None  # a name that is missing costs another criterion
    if what != "returned":
        return see.failed(
            "refuses-wrong-words.message-refused",
            f"{GOOD_MESSAGE} raised {what}",
            expected,
            "Your publisher refuses a message of the right type.",
            "Refuse only what is not a String.",
        )
    asked = times_done(recording, GOOD_WORD) + times_done(recording, GOOD_MESSAGE)
    sent = see.values(recording, STATUS).count("error")
    if sent >= asked:
        return None
    return see.failed(
        "refuses-wrong-words.message-lost",
        f'"error" arrived {see.count(sent, "time")} in {asked} calls of send_status and status_publisher.publish',
        expected,
        "Some of these calls send nothing, and raise no error. status_publisher may not be the publisher that sends on "
        "the topic, or a word is dropped when it comes again.",
        "Send each message that is given, in send_status and in status_publisher.publish.",
    )


# --- whether numbers arrive ---------------------------------------------------------------------------------


def why_refused(recording: Recording, call: str) -> Verdict | None:
    """A failed verdict if a call with a number, or with a right message, raised an error."""
    raised = outcomes(recording).get(call, "returned")
    if raised == "returned":
        return None

    def fail(cause: str, because: str, try_this: str) -> Verdict:
        return see.failed(cause, f"{call} raised {raised}", numbers_expected(call), because, try_this)

    if call == ZERO:
        return fail(
            "numbers-arrive.zero-refused",
            "0.0 is a number as well: the charge of an empty battery. In a condition it counts as false, like None. "
            "And `0.0 < level` leaves it out.",
            "Check whether it is a number: isinstance(level, (int, float)).",
        )
    if is_whole(call):
        return fail(
            "numbers-arrive.refused",
            "A whole number is a number, and mypy accepts an int where a float is expected. But "
            "isinstance(level, float) is False for an int.",
            "Accept both with isinstance(level, (int, float)), and pass float(level) to the message.",
        )
    return fail(
        "numbers-arrive.check-too-strict",
        "Your check refuses more than it may, or this call depends on an earlier one.",
        "Refuse only what is not a number, or not a message of the right type.",
    )


def why_not_arrived(recording: Recording, call: str, number: float) -> Verdict | None:
    """A failed verdict if a number that a call accepted did not arrive once as this number."""
    arrived, orders = see.values(recording, BATTERY), len(see.published(recording, "/driver/go"))
    asked = 2 * orders if call == called_twice(recording) else orders

    def fail(cause: str, saw: str, because: str, try_this: str) -> Verdict:
        return see.failed(cause, f"{call} sent {saw}", numbers_expected(call), because, try_this)

    if not numbers_of(recording).intersection(arrived):
        return fail(
            "numbers-arrive.not-sent",
            f"nothing that arrived on {BATTERY.name}",
            "The message was sent on another topic, or not at all.",
            f"Publish it with the publisher for {BATTERY.name!r}.",
        )
    if number not in arrived:
        return fail(*why_changed(recording, call, number))
    if number and arrived.count(number) > asked:
        return fail(
            "numbers-arrive.sent-again",
            f"{number} {arrived.count(number)} times in {see.count(asked, 'call')}",
            "Something publishes this number once more: a second publish(), or a timer.",
            "Publish once in each call.",
        )
    return why_not_each_time(recording, call, number)


def why_not_each_time(recording: Recording, call: str, number: float) -> Verdict | None:
    """A failed verdict if a number arrived in some calls, and in others not."""
    arrived, done = see.values(recording, BATTERY).count(number), times_done(recording, call)
    if arrived >= done:
        return None
    saw = f"{call} sent {number} {see.count(arrived, 'time')} in {see.count(done, 'call')}"
    hint = "Publish in each call, whatever was sent before."
    if call == called_twice(recording) and arrived <= len(see.published(recording, "/driver/go")):
        return see.failed(
            "numbers-arrive.repeat-dropped",
            saw,
            numbers_expected(call),
            "A number that equals the one before is not sent again. A listener then cannot tell a charge that stays "
            "the same from a robot that is silent.",
            hint,
        )
    return see.failed(
        "numbers-arrive.not-each-time",
        saw,
        numbers_expected(call),
        "A condition or a counter skips the publish() in some calls, and no error is raised.",
        hint,
    )


ZERO_DROPPED = (
    "numbers-arrive.zero-dropped",
    "nothing that arrived as 0.0",
    "0.0 counts as false in a condition: `if level:` treats it like a missing number. Or the level is limited to a "
    "smallest value above 0.",
    "Publish 0.0 like any other number.",
)


def why_changed(recording: Recording, call: str, number: float) -> tuple[str, str, str, str]:
    """Why a number did not arrive, although others did: cause, what was seen, because, try."""
    if is_whole(call) and zeros_too_many(recording):
        return (
            "numbers-arrive.not-converted",
            "0.0",
            "mypy accepts an int where a float is expected. The message does not: this build sends 0.0 for "
            "it, and reports no error. The Ubuntu packages may abort the program instead.",
            "Pass float(level) to the message.",
        )
    if call == ZERO:
        return ZERO_DROPPED
    if number < 1.0 and 100.0 * number in see.values(recording, BATTERY):
        return (
            "numbers-arrive.share",
            see.number(100.0 * number),
            "A number up to 1 is taken for a share, and multiplied by 100. A nearly empty battery then looks fuller.",
            "Pass float(level) to the message: every level is a percentage.",
        )
    rounded = {float(int(number)), *(round(number, digits) for digits in range(5))} - {
        0.0
    }  # 0.0 is sent, too
    near = [
        one for one in see.values(recording, BATTERY) if any(abs(one - way) < ROUNDING for way in rounded)
    ]
    if near:
        return (
            "numbers-arrive.rounded",
            f"{see.number(near[0])}",
            "Decimals are cut off or rounded: by int(), round() or //.",
            "Pass float(level) to the message, and round where a number is displayed.",
        )
    return (
        "numbers-arrive.changed",
        f"nothing that arrived as {number}",
        "The number is changed, replaced or dropped before it is sent.",
        "Pass float(level) to the message, whatever was sent before.",
    )


def numbers_expected(call: str) -> str:
    return f"{level_of(call)} on {BATTERY.name}, once after each {call}"


# --- what the driver sent, and what became of its calls -----------------------------------------------------


def by_itself(recording: Recording) -> Recording:
    """The recording without what the driver sent through the node.

    The driver makes its calls in one callback, from an order to its report. The node's timers do not run meanwhile, but
    a thread of its own may: what fits between its other reports is the node's.
    """
    reported = [one.published for one in recording.topic(REPORT.name).arrivals]
    spans = [
        (order.wall, min((moment for moment in reported if moment >= order.wall), default=order.wall))
        for order in see.published(recording, "/driver/go")
    ]
    topics, numbers = dict(recording.topics), numbers_of(recording)
    for one, kind in ((BATTERY, float), (STATUS, str)):
        seen = recording.topic(one.name)
        seen = replace(
            seen, arrivals=tuple(it for it in seen.arrivals if isinstance(it.value.get("data"), kind))
        )
        within = [any(begin <= one.published <= end for begin, end in spans) for one in seen.arrivals]
        outside = [arrival for arrival, inside in zip(seen.arrivals, within, strict=True) if not inside]
        own = tuple(
            arrival
            for arrival, inside in zip(seen.arrivals, within, strict=True)
            if not inside or fits_between(arrival, outside, numbers)
        )
        topics[one.name] = replace(seen, arrivals=own)
    return replace(recording, topics=topics)


def fits_between(arrival: see.Arrival, outside: list[see.Arrival], numbers: set[float]) -> bool:
    """Whether the node itself may have reported this while the driver made its calls: nothing that the driver sent, and
    below the charge before it and above the one after it."""
    value = arrival.value["data"]
    if isinstance(value, str):
        return value == "operational"
    before = [one.value["data"] for one in outside if one.published < arrival.published]
    after = [one.value["data"] for one in outside if one.published > arrival.published]
    return value not in numbers and bool(before and after) and before[-1] > value > after[0]


def ordered_calls(recording: Recording) -> list[str]:
    """The calls of one order, as one writes them."""
    orders = see.script(recording, "/driver/go")
    return orders[0].value["data"].splitlines() if orders else []


def number_calls(recording: Recording) -> dict[str, float]:
    """The calls that send a number, each once: a whole one first, the smallest ones last."""
    found = {call: level for call in ordered_calls(recording) if (level := level_of(call)) is not None}
    return dict(sorted(found.items(), key=lambda one: (not is_whole(one[0]), one[1] < 1.0, one[1])))


def level_of(call: str) -> float | None:
    """The number that a call sends; None if it must send none."""
    found = NUMBER_CALL.fullmatch(call)
    return float(found[1]) if found else None


def numbers_of(recording: Recording) -> set[float]:
    """The numbers that the driver sends, or that may become of its wrong calls."""
    return {*number_calls(recording).values(), *WRONG_LEVELS}


def is_whole(call: str) -> bool:
    """Whether a call sends an int."""
    found = NUMBER_CALL.fullmatch(call)
    return found is not None and found[1].isdecimal()


def called_twice(recording: Recording) -> str:
    """The call that the driver makes twice in a row; its last one with a right number."""
    made = Counter(ordered_calls(recording))
    return next((call for call, times in made.items() if times > 1), "")


def outcomes(recording: Recording) -> dict[str, str]:
    """What became of each call of the driver: "returned", or the error; empty when it never came to its calls.

    It makes all calls twice. If they ended differently, the end that should not be counts.
    """
    found: dict[str, str] = {}
    for call, what in calls_made(recording):
        right = call in (GOOD_WORD, GOOD_MESSAGE) or level_of(call) is not None
        if call not in found or (what == "returned") != right:
            found[call] = what
    return found


def calls_made(recording: Recording) -> list[tuple[str, str]]:
    """Each call that the driver made, in their order, and what became of it."""
    lines = [line for text in see.driver_reports(recording, REPORT) for line in text.splitlines()]
    return [(call, what) for call, mark, what in (line.partition("\t") for line in lines) if mark]


def times_done(recording: Recording, call: str) -> int:
    """How often the driver made a call that raised nothing."""
    return calls_made(recording).count((call, "returned"))


def now_and_then(recording: Recording, calls: tuple[str, ...]) -> str | None:
    """The first of these calls that raised an error once, and none another time; None if each ended alike."""
    ends = {(call, what == "returned") for call, what in calls_made(recording)}
    return next((call for call in calls if {(call, True), (call, False)} <= ends), None)


def never_called() -> Verdict:
    """The driver never came to its calls."""
    return see.failed(
        "driver.never-called",
        "your node could not be used from outside: the code that calls it never ran",
        "a module that can be imported without starting to spin",
        "The file starts to spin as soon as it is imported, or a callback never returns.",
        'Keep `if __name__ == "__main__":` before main() at the end of the file.',
    )


def first_accepted(recording: Recording, calls: tuple[str, ...]) -> str | None:
    """The first of these calls that raised no error."""
    found = outcomes(recording)
    return next((call for call in calls if found.get(call, "returned") == "returned"), None)


def sent_among(recording: Recording, one: Topic, wrong: tuple[object, ...]) -> list[object]:
    """What arrived on a topic of these values, which nobody should have sent."""
    return [value for value in see.values(recording, one) if value in wrong]


def zeros_too_many(recording: Recording) -> int:
    """How many zeros arrived that nobody asked for: each order asks for one."""
    asked = sum(f"{ZERO}\treturned" in text for text in see.driver_reports(recording, REPORT))
    return max(0, see.values(recording, BATTERY).count(0.0) - asked)


# --- whether wrong calls are refused ------------------------------------------------------------------------


def refuses_wrong_numbers(recording: Recording) -> Verdict:
    """A call with something that is no number raises an error, and sends nothing."""
    sent = number_sent(recording)
    accepted = first_accepted(recording, WRONG_NUMBERS)
    if accepted is None:
        return refused(recording, WRONG_NUMBERS, sent)
    saw, expected = raised_nothing(accepted, sent), errors_expected(WRONG_NUMBERS)
    hint = "Before publishing: if not isinstance(level, (int, float)): raise TypeError(...)"
    found = outcomes(recording)
    once = now_and_then(recording, WRONG_NUMBERS)
    if once is not None:
        return refused_once(once, expected)
    if all(call in READ_AS_NUMBERS for call in WRONG_NUMBERS if found.get(call) == "returned"):
        return see.failed(
            "refuses-wrong-types.text-read",
            saw,
            expected,
            "float('87.5') turns a text into a number, and float(b'87.5') does so with bytes. The next may be '87 %'. "
            "A caller's mistake should not be accepted by chance.",
            hint,
        )
    if accepted == NO_NUMBER and sent == ZERO_SENT:
        return none_becomes_zero(saw, expected)
    if not sent:
        return see.failed(
            "refuses-wrong-types.value-dropped",
            saw,
            expected,
            DROPPED,
            "Raise TypeError if the level is not a number.",
        )
    return see.failed(
        "refuses-wrong-types.value-accepted",
        saw,
        expected,
        "Hints are for readers; Python ignores them at run time. This build of ROS does not check either: it "
        "sends anything that is not a float as 0.0.",
        hint,
    )


def none_becomes_zero(saw: str, expected: str) -> Verdict:
    """None was sent as 0.0, though texts are refused."""
    return see.failed(
        "refuses-wrong-types.none-becomes-zero",
        saw,
        expected,
        "Your check refuses other wrong values, but turns None into 0.0, as `level or 0.0` does. The battery then "
        "looks empty.",
        "Check the level as it was given: if not isinstance(level, (int, float)): raise TypeError(...)",
    )


def refused_once(call: str, expected: str) -> Verdict:
    """The same call raised an error, and later or earlier none."""
    return see.failed(
        "refuses-wrong-types.not-each-time",
        f"{call} raised an error once, and nothing another time",
        expected,
        "The same wrong value is refused in one call, and not in another. Your check counts or remembers, or is "
        "skipped for some calls.",
        "Check in every call, before publishing: if not isinstance(level, (int, float)): raise TypeError(...)",
    )


def number_sent(recording: Recording) -> str:
    """What arrived because of a wrong number, in words; empty if nothing did."""
    found = outcomes(recording)
    wrong = [*sent_among(recording, BATTERY, (87.5, 50.0)), *[0.0] * zeros_too_many(recording)]
    # An int that became 0.0 is the business of numbers_arrive.
    whole, number = next(
        ((call, number) for call, number in number_calls(recording).items() if is_whole(call)), ("", 0.0)
    )
    if found.get(whole) == "returned" and number not in see.values(recording, BATTERY):
        wrong = [value for value in wrong if value != 0.0 or "returned" in map(found.get, WRONG_NUMBERS)]
    return f"{wrong[0]} was sent on {BATTERY.name}" if wrong else ""


def refuses_wrong_messages(recording: Recording) -> Verdict:
    """A publisher that is given a message of another type raises an error."""
    accepted = first_accepted(recording, WRONG_MESSAGES)
    if accepted is None:
        return refused(recording, WRONG_MESSAGES, "")
    if accepted in NO_MESSAGES:
        return see.failed(
            "refuses-wrong-types.no-message-accepted",
            raised_nothing(accepted, ""),
            errors_expected(WRONG_MESSAGES),
            "Your publisher turns what it is given into a message, or drops it. It must accept messages of one "
            "type and nothing else.",
            "Pass the argument on to rclpy's publisher, which refuses a wrong type, or raise a TypeError.",
        )
    return see.failed(
        "refuses-wrong-types.message-accepted",
        raised_nothing(accepted, ""),
        errors_expected(WRONG_MESSAGES),
        "rclpy refuses such a message with a TypeError. Your code catches that error, or makes another message of "
        "what it was given.",
        "Pass the message to rclpy's publisher as it is, and do not catch its error: the caller must see it.",
    )


def refused(recording: Recording, calls: tuple[str, ...], sent: str) -> Verdict:
    """All of these calls raised an error; `sent` says what arrived nevertheless, if something did."""
    found = outcomes(recording)
    if sent:
        return see.failed(
            "refusal.too-late",
            f"{calls[0]} raised {found[calls[0]].split(':')[0]}, but {sent}",
            errors_expected(calls),
            "The message had already been sent when the error was raised.",
            "Check the value first, and publish only when it is right.",
        )
    return see.passed(f"{calls[0]} raises {found[calls[0]]}")


def raised_nothing(call: str, sent: str) -> str:
    return f"{call} raised nothing, and {sent}" if sent else f"{call} raised nothing"


def errors_expected(calls: tuple[str, ...]) -> str:
    return f"an error from each of {len(calls)} wrong calls, and nothing sent"
