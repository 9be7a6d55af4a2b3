"""Judge exercise 07: mypy checks the node and code that uses it, and a driver calls the node's methods at run time.

Each run draws the numbers that the driver sends, and the order of its calls.
"""

import re
from collections import Counter
from dataclasses import replace
from random import Random

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, probe, program_runs, topic, watching

WORDS = see.Words(__file__)

BATTERY = topic("/robot/battery", Float32, hz=1.0)
STATUS = topic("/robot/status", String, hz=0.5)
REPORT = topic("/driver/report", String, signed=True)
# The values that wrong calls would publish. The node itself never publishes these.
WRONG_LEVELS = (87.5, 50.0, 12.5)
NEVER_SENT = (
    "operatoinal", "3", "None", "Error", " error", "error\n", "oper", "error: arm", "charging", "",
)  # fmt: skip
ROUNDING = 1e-4  # the largest difference between a number that arrived and a rounded number
ZERO = "send_battery(0.0)"
NEAR = 1.0  # the most (%) by which a node may drain until its next own report
NUMBER_CALL = re.compile(r"(?:send_battery\(|battery_publisher\.publish\(Float32\(data=)(\d+(?:\.\d+)?)\)+")
GOOD_WORD = "send_status('error')"
GOOD_MESSAGE = "status_publisher.publish(String(data='error'))"
READ_AS_NUMBERS = ("send_battery('87.5')", "send_battery(b'87.5')")  # float() accepts both
NO_NUMBER = "send_battery(None)"
WRONG_NUMBERS = (
    "send_battery('full')", *READ_AS_NUMBERS, NO_NUMBER, "send_battery([50.0])", "send_battery((50.0,))",
)  # fmt: skip
NO_TEXTS = ("send_status(3)", "send_status(None)", "send_status(b'error')", "send_status(Path('error'))")
WRONG_WORDS = (
    "send_status('operatoinal')", *NO_TEXTS, "send_status('Error')", "send_status(' error')",
    "send_status('error\\n')", "send_status('oper')", "send_status('error: arm')", "send_status('charging')",
    "send_status('')",
)  # fmt: skip
NO_MESSAGES = (
    "battery_publisher.publish(12.5)", "status_publisher.publish('oper')",
    "battery_publisher.publish(None)", "status_publisher.publish(None)",
)  # fmt: skip
WRONG_MESSAGES = (
    "battery_publisher.publish(String())", "battery_publisher.publish(Float64(data=12.5))",
    "status_publisher.publish(Float32())", *NO_MESSAGES,
)  # fmt: skip


def drawn_calls(rng: Random, numbers: list[str], twice: str) -> str:
    """Return one order: all calls, one per line, with the call `twice` made twice in a row after all other numbers.

    Among the wrong words, a string comes first, which exposes a check that refuses only once.
    """
    calls = [*numbers, GOOD_WORD, GOOD_MESSAGE, *WRONG_NUMBERS, *WRONG_WORDS, *WRONG_MESSAGES]
    rng.shuffle(calls)
    while next(call for call in calls if call in WRONG_WORDS) in NO_TEXTS:
        rng.shuffle(calls)
    after = 1 + max(calls.index(call) for call in numbers if call.startswith("send_battery"))
    place = rng.randint(after, len(calls))
    return "\n".join([*calls[:place], twice, twice, *calls[place:]])


def drawn(rng: Random) -> list[see.Part]:
    """Draw the script: one order in each half of the watch. Both orders contain the same calls."""
    levels = (
        f"{rng.randrange(21, 80, 2)}",
        f"{rng.randint(21, 79)}.25",
        "0.0",
        f"{rng.randrange(5, 29, 2) / 32}",
        f"{rng.randint(21, 79) + rng.randrange(1, 64, 2) / 64}",
        rng.choice(("99.9375", "99.8125")),  # more than the node's own charge
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
OTHER_WORDS = (
    "warning", "unknown", "ok", "idle", "ready", "busy", "standby", "low", "low battery",
    "low_battery", "empty", "degraded", "maintenance", "fault", "failed", "stopped", "offline", "emergency",
    "OPERATIONAL", "ERROR", "",
)  # fmt: skip
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
    """
    + "".join(f'    robot.send_status("{word}")  # wrong\n    ' for word in OTHER_WORDS),
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


def level_of(call: str) -> float | None:
    """Return the number that a call must publish, or None if it mustn't publish a number."""
    found = NUMBER_CALL.fullmatch(call)
    return float(found[1]) if found else None


def is_whole(call: str) -> bool:
    """Return whether a call's argument is an int."""
    found = NUMBER_CALL.fullmatch(call)
    return found is not None and found[1].isdecimal()


class Use:
    """The driver's calls, their outcomes, and the messages that arrived."""

    def __init__(self, recording: Recording) -> None:
        self.recording = recording
        self.orders = [one.wall for one in see.published(recording, "/driver/go")]  # wall time, s
        ordered = [one.value["data"].splitlines() for one in see.script(recording, "/driver/go")][:1]
        calls = [call for order in ordered for call in order]  # each as Python source
        # Each call that publishes a number, once: ints first, numbers below 1 last.
        numbers = {call: level for call in calls if (level := level_of(call)) is not None}
        by_kind = sorted(numbers.items(), key=lambda one: (not is_whole(one[0]), one[1] < 1.0, one[1]))
        self.numbers = dict(by_kind)
        # The call that the driver makes twice in a row. It's the last call with a right number.
        self.twice = next((call for call, times in Counter(calls).items() if times > 1), "")
        # All values that may come from the driver, including those of wrong calls.
        self.sent = {*self.numbers.values(), *WRONG_LEVELS}

        # Each call that was made, and its outcome: "returned" or the error.
        reports = see.driver_reports(recording, REPORT)
        parts = [line.partition("\t") for text in reports for line in text.splitlines()]
        self.made = [(call, end) for call, mark, end in parts if mark]
        # If a call had different outcomes, the wrong one counts.
        self.ends: dict[str, str] = {}
        for call, end in self.made:
            is_right = call in (GOOD_WORD, GOOD_MESSAGE) or level_of(call) is not None
            if call not in self.ends or (end == "returned") != is_right:
                self.ends[call] = end
        self.word_end = self.ends.get(GOOD_WORD)
        self.message_end = self.ends.get(GOOD_MESSAGE, "returned")
        self.has_publisher = not self.message_end.startswith("AttributeError")  # else another criterion fails

        self.levels = see.values(recording, BATTERY)
        self.words = see.values(recording, STATUS)
        self.errors = self.words.count("error")
        self.errors_asked = self.times_done(GOOD_WORD) + self.times_done(GOOD_MESSAGE)
        # Each order requests one 0.0.
        asked = sum(f"{ZERO}\treturned" in text for text in reports)
        self.zeros_too_many = max(0, self.levels.count(0.0) - asked)

        # The node's own reports, without the values that the driver sent through the node. The driver makes its calls
        # in one callback, between an order's arrival and the reports. During this time, the node's timers don't fire,
        # but a thread of the node may publish. So a value that fits between the node's other reports counts as the
        # node's own.
        reported = [one.published for one in recording.topic(REPORT.name).arrivals]
        spans = [(at, min((end for end in reported if end >= at), default=at)) for at in self.orders]
        topics = dict(recording.topics)
        for one, kind in ((BATTERY, float), (STATUS, str)):
            seen = recording.topic(one.name)
            sound = [it for it in seen.arrivals if isinstance(it.value.get("data"), kind)]
            placed = [(it, any(begin <= it.published <= end for begin, end in spans)) for it in sound]
            others = [it for it, is_inside in placed if not is_inside]
            own = tuple(it for it, is_inside in placed if not is_inside or self.fits_between(it, others))
            topics[one.name] = replace(seen, arrivals=own)
        self.own = replace(recording, topics=topics)

        # the node's charges before and after each order, or [] if one of them is missing
        charges = [(one.published, one.value["data"]) for one in self.own.topic(BATTERY.name).arrivals]
        before = [[level for at, level in charges if at < order][-1:] for order in self.orders]
        after = [[level for at, level in charges if at >= order][:1] for order in self.orders]
        pairs = zip(before, after, strict=True)
        self.around_orders = [(a, b) for [a], [b] in pairs] if all(before) and all(after) else []
        # After each order, the node continues with the driver's last number.
        last = self.numbers.get(self.twice, 0.0)
        goes_on = all(0.0 <= last - after <= NEAR for _, after in self.around_orders)
        jumps = [abs(before - last) > NEAR for before, _ in self.around_orders]
        self.level_replaced = goes_on and any(jumps[:1])
        # From the driver's first calls on, the node publishes "error", although its battery has charge.
        first = min(self.orders, default=0.0)
        said = {(one.published < first, one.value["data"]) for one in self.own.topic(STATUS.name).arrivals}
        changes = said == {(True, "operational"), (False, "error")}
        self.error_kept = bool(self.orders) and changes and 0.0 not in see.values(self.own, BATTERY)

    def times_done(self, call: str) -> int:
        """Return the number of times that the driver made this call without an error."""
        return self.made.count((call, "returned"))

    def fits_between(self, arrival: see.Arrival, others: list[see.Arrival]) -> bool:
        """Return whether an arrival may be the node's own report rather than one of the driver's values.

        An own report is "operational", or a charge between the charges before and after it.
        """
        value = arrival.value["data"]
        if isinstance(value, str):
            return value == "operational"
        before = [one.value["data"] for one in others if one.published < arrival.published]
        after = [one.value["data"] for one in others if one.published > arrival.published]
        return value not in self.sent and bool(before and after) and before[-1] > value > after[0]


class NumberCall:
    """One of the calls that publish a number."""

    def __init__(self, use: Use, call: str) -> None:
        self.use, self.call, self.number = use, call, use.numbers[call]
        end = use.ends.get(call, "returned")
        self.raised = "" if end == "returned" else end
        self.arrived = use.levels.count(self.number)
        self.done = use.times_done(call)
        self.is_twice = call == use.twice
        self.asked = len(use.orders) * (2 if self.is_twice else 1)
        self.as_share = 100.0 * self.number

    @property
    def near(self) -> list[float]:
        """The values that may be this number after rounding. 0.0 is left out, because the driver sends 0.0 as well."""
        rounded = {float(int(self.number)), *(round(self.number, digits) for digits in range(5))} - {0.0}
        return [level for level in self.use.levels if any(abs(level - one) < ROUNDING for one in rounded)]


class Refusals:
    """Calls that must raise an error. `sent`: a value that arrived because of such a call, or "" if none did."""

    def __init__(self, use: Use, calls: tuple[str, ...], topic: str = BATTERY.name) -> None:
        self.use, self.calls, self.topic, self.sent = use, calls, topic, ""
        returned = [call for call in calls if use.ends.get(call, "returned") == "returned"]
        self.accepted = [*returned, ""][0]  # "" if each call raised an error
        self.returned = {call for call in returned if call in use.ends}
        # the first call that raised an error only one of the two times
        ends = {(call, end == "returned") for call, end in use.made}
        differing = [call for call in calls if {(call, True), (call, False)} <= ends]
        self.now_and_then = [*differing, ""][0]
        self.error = use.ends.get(calls[0], "").split(":")[0]
        texts = {*WRONG_WORDS} - {*NO_TEXTS}
        self.refuses_a_text = any(call in texts and end != "returned" for call, end in use.made)

    @property
    def is_sent(self) -> bool:
        return bool(self.sent)


def wrong_numbers(use: Use) -> Refusals:
    """Return the calls whose argument isn't a number.

    A 0.0 that arrived in place of an int is left out here, because the criterion `numbers_arrive` judges it.
    """
    calls = Refusals(use, WRONG_NUMBERS)
    whole = next(filter(is_whole, use.numbers), "")
    whole_lost = use.ends.get(whole) == "returned" and use.numbers[whole] not in use.levels
    zeros = [] if whole_lost and not calls.returned else [0.0] * use.zeros_too_many
    sent = [*(level for level in use.levels if level in (87.5, 50.0)), *zeros]
    calls.sent = str(sent[0]) if sent else ""
    return calls


def wrong_words(use: Use) -> Refusals:
    """Return the calls whose word isn't a status.

    If an answer publishes "error" in place of such a word, "error" arrives more often than requested.
    """
    calls = Refusals(use, WRONG_WORDS, STATUS.name)
    wrong = [word for word in use.words if word in NEVER_SENT]
    of_accepted = [word for word in wrong if repr(word) in calls.accepted]
    own = calls.accepted or "error" in see.values(use.own, STATUS)
    if wrong:
        calls.sent = repr([*of_accepted, *wrong][0])
    elif not own and use.errors > use.errors_asked and use.errors != 2 * use.errors_asked:
        calls.sent = '"error"'
    return calls


facts = see.once(Use)

NEVER_CALLED = WORDS.cause("driver.never-called", ())
BEFORE = WORDS.rules(
    Use,
    "reports-as-before",
    ("level-replaced", lambda use: use.level_replaced),
    ("error-kept", lambda use: use.error_kept),
)
TAKES_ANY = WORDS.reason("wrong-message-found.publisher-takes-any")
TOO_WIDE = WORDS.reason("wrong-value-found.hint-too-wide")
DEFAULT = WORDS.reason("wrong-value-found.default")
NUMBERS = WORDS.rules(
    NumberCall,
    "numbers-arrive",
    ("zero-refused", lambda one: one.raised and one.call == ZERO),
    ("refused", lambda one: one.raised and is_whole(one.call)),
    ("check-too-strict", lambda one: one.raised),
    ("not-sent", lambda one: one.use.sent.isdisjoint(one.use.levels)),
    ("not-converted", lambda one: not one.arrived and is_whole(one.call) and one.use.zeros_too_many),
    ("zero-dropped", lambda one: not one.arrived and one.call == ZERO),
    ("share", lambda one: not one.arrived and one.number < 1.0 and one.as_share in one.use.levels),
    ("rounded", lambda one: not one.arrived and one.near),
    ("changed", lambda one: not one.arrived),
    ("sent-again", lambda one: one.number and one.arrived > one.asked),
    ("repeat-dropped", lambda one: one.is_twice and one.arrived < one.done and 2 * one.arrived <= one.asked),
    ("not-each-time", lambda one: one.arrived < one.done),
)
TOO_LATE = WORDS.cause("refusal.too-late", Refusals)
NUMBER_ACCEPTED = WORDS.rules(
    Refusals,
    "refuses-wrong-types",
    ("not-each-time", lambda calls: calls.now_and_then),
    ("text-read", lambda calls: calls.returned <= {*READ_AS_NUMBERS}),
    ("none-becomes-zero", lambda calls: calls.accepted == NO_NUMBER and calls.sent == "0.0"),
    ("value-dropped", lambda calls: not calls.sent),
    ("value-accepted", see.otherwise),
)
MESSAGE_ACCEPTED = WORDS.rules(
    Refusals,
    "refuses-wrong-types",
    ("no-message-accepted", lambda calls: calls.accepted in NO_MESSAGES),
    ("message-accepted", see.otherwise),
)
WORD_ACCEPTED = WORDS.rules(
    Refusals,
    "refuses-wrong-words",
    ("check-too-loose", lambda calls: calls.refuses_a_text),
    ("dropped", lambda calls: not calls.sent),
    ("accepted", see.otherwise),
)
GOOD_WORD_LOST = WORDS.rules(
    Use,
    "refuses-wrong-words",
    ("good-word-refused", lambda use: use.word_end != "returned"),
    ("good-word-lost", lambda use: not use.errors),
    ("message-refused", lambda use: use.has_publisher and use.message_end != "returned"),
    ("message-lost", lambda use: use.has_publisher and use.errors < use.errors_asked),
)


@criterion(
    points=1,
    title="The node reports as before: the battery at 1 Hz and the status at 0.5 Hz",
    needs=[program_runs],
)
def reports_as_before(recording: Recording) -> Verdict:
    use = facts(recording)
    return BEFORE.first(use) or see.all_of(
        see.publishes(use.own, BATTERY),
        see.publishes(use.own, STATUS),
        see.rate(use.own, BATTERY),
        see.rate(use.own, STATUS),
        see.within(use.own, BATTERY, 0.0, 100.0, "%"),
        see.one_of(use.own, STATUS, {"operational", "error"}),
        see.drains(use.own, BATTERY),
        see.word_fits_charge(use.own, STATUS, BATTERY),
    )


@criterion(points=2, title="mypy --strict reports no errors in your program", needs=[program_runs])
def clean(recording: Recording) -> Verdict:
    return see.mypy_clean(recording)


@criterion(points=0, title="mypy accepts correct use of your node", needs=[program_runs])
def right_use(recording: Recording) -> Verdict:
    return see.mypy_accepts(recording, RIGHT_USE)


@criterion(
    points=2,
    title="mypy reports an error if a publisher is passed a message of the wrong type",
    needs=[right_use],
)
def wrong_message_found(recording: Recording) -> Verdict:
    return see.mypy_objects(recording, WRONG_MESSAGE, TAKES_ANY)


@criterion(
    points=1,
    title="mypy reports an error for a value of the wrong type, a wrong word, or a missing value",
    needs=[right_use],
)
def wrong_value_found(recording: Recording) -> Verdict:
    return see.all_of(
        see.mypy_objects(recording, WRONG_VALUE, TOO_WIDE), see.mypy_objects(recording, NO_VALUE, DEFAULT)
    )


@criterion(
    points=1,
    title="Every number arrives unchanged, even a whole number or a repeated one",
    needs=[program_runs],
)
def numbers_arrive(recording: Recording) -> Verdict:
    use = facts(recording)
    if not use.made:
        return NEVER_CALLED.verdict()
    found = (NUMBERS.first(NumberCall(use, call)) for call in use.numbers)
    well = f"{see.count(len(use.numbers), 'number')} arrived, including 0.0 and a repeated number"
    return next(filter(None, found), see.passed(well))


@criterion(
    points=2,
    title="At run time, a value or message of the wrong type raises an exception",
    needs=[program_runs],
)
def refuses_wrong_types(recording: Recording) -> Verdict:
    use = facts(recording)
    if not use.made:
        return NEVER_CALLED.verdict()
    numbers = wrong_numbers(use)
    messages = refused(Refusals(use, WRONG_MESSAGES), MESSAGE_ACCEPTED)
    if not numbers.accepted and not messages.ok:
        return messages  # the value that arrived may have come from a message
    return see.all_of(refused(numbers, NUMBER_ACCEPTED), messages)


@criterion(
    points=1,
    title="At run time, the two words are published, and any other word raises an exception",
    needs=[program_runs],
)
def refuses_wrong_words(recording: Recording) -> Verdict:
    use = facts(recording)
    if not use.made:
        return NEVER_CALLED.verdict()
    good = GOOD_WORD_LOST.first(use) or see.passed(f"{GOOD_WORD} publishes it")
    return see.all_of(refused(wrong_words(use), WORD_ACCEPTED), good)


def refused(calls: Refusals, accepted: see.Rules[Refusals]) -> Verdict:
    """Check that each of these calls raised an error and didn't publish a value.

    `accepted`: the rules that apply if a call didn't raise an error.
    """
    if calls.accepted:
        return accepted.verdict(calls)
    first = calls.calls[0]
    return TOO_LATE.verdict(calls) if calls.sent else see.passed(f"{first} raises {calls.use.ends[first]}")
