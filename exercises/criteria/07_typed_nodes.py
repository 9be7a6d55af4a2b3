"""How exercise 07 is judged: mypy reads the node and code that uses it, and a driver uses it while it runs."""

from dataclasses import replace

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import Recording, Topic, Verdict, criterion, probe, program_runs, topic, watching

BATTERY = topic("/robot/battery", Float32, hz=1.0)
STATUS = topic("/robot/status", String, hz=0.5)
REPORT = topic("/driver/report", String)
WATCH = watching(
    robot_seconds=12,
    script=[see.says("/driver/go", String, [(2.6, "go"), (8.6, "go")])],  # one in each half of the watch
)

# What the driver sends, or what becomes of it; the node itself sends other values.
NUMBERS = (42.0, 55.25, 87.5, 0.0, 12.5)
NEVER_SENT = ("operatoinal", "3", "Error", " error", "oper", "charging", "")
WORDS = ("error", *NEVER_SENT)
SOON_S = 1.5  # after an order the driver has made its calls
JUST_BEFORE_S = 0.01  # slack for rounded time stamps
ZERO = "send_battery(0.0)"
NUMBER_CALLS = {"send_battery(42)": 42.0, "send_battery(55.25)": 55.25, ZERO: 0.0}
DIGITS = "send_battery('87.5')"
WRONG_NUMBERS = ("send_battery('full')", DIGITS, "send_battery(None)")
WRONG_WORDS = (
    "send_status('operatoinal')",
    "send_status(3)",
    "send_status('Error')",
    "send_status(' error')",
    "send_status('oper')",
    "send_status('charging')",
    "send_status('')",
)
WRONG_MESSAGES = (
    "battery_publisher.publish(String())",
    "status_publisher.publish(Float32())",
    "battery_publisher.publish(12.5)",
    "status_publisher.publish('oper')",
)

RIGHT_USE = probe(
    "correct use of your node",
    """
    from answer import RobotReport
    from std_msgs.msg import Float32, String

    def use(robot: RobotReport) -> None:
        robot.send_battery(55.25)
        robot.send_battery(42)
        robot.send_status("error")
        robot.battery_publisher.publish(Float32(data=55.25))
        robot.status_publisher.publish(String(data="operational"))
    """,
)
WRONG_MESSAGE = probe(
    "a message of the wrong type",
    """
    from answer import RobotReport
    from std_msgs.msg import Float32, String

    def use(robot: RobotReport) -> None:
        robot.battery_publisher.publish(Float32(data=55.25))
        robot.status_publisher.publish(String(data="operational"))
        robot.battery_publisher.publish(String(data="full"))  # wrong
        robot.status_publisher.publish(Float32(data=55.25))  # wrong
        robot.battery_publisher.publish(55.25)  # wrong
        robot.status_publisher.publish("operational")  # wrong
    """,
)
WRONG_VALUE = probe(
    "a value of the wrong type",
    """
    from answer import RobotReport

    def use(robot: RobotReport) -> None:
        robot.send_battery(55.25)
        robot.send_status("error")
        robot.send_battery("full")  # wrong
        robot.send_battery(None)  # wrong
        robot.send_status("operatoinal")  # wrong
        robot.send_status(3)  # wrong
        robot.send_status("Error")  # wrong
        robot.send_status("charging")  # wrong
        robot.send_status("warning")  # wrong
        robot.send_status("unknown")  # wrong
        robot.send_status("ok")  # wrong
        robot.send_status("")  # wrong
    """,
)


@criterion(
    points=1,
    title="The node reports as before: the battery at 1 Hz, the status at 0.5 Hz",
    needs=[program_runs],
)
def reports_as_before(recording: Recording) -> Verdict:
    own = by_itself(recording)
    return see.all_of(
        see.publishes(own, BATTERY),
        see.publishes(own, STATUS),
        see.rate(own, BATTERY),
        see.rate(own, STATUS),
        see.within(own, BATTERY, 0.0, 100.0, "%"),
        see.one_of(own, STATUS, {"operational", "error"}),
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
        because="To mypy this attribute is Any, or rclpy's own Publisher, which does not know its message type. "
        "Both accept every message.",
        try_this="Annotate the attributes with a Protocol that has a publish method for one type: "
        "self.battery_publisher: Sends[Float32] = ...",
    )


@criterion(points=1, title="mypy objects to a wrong value and to a misspelled word", needs=[right_use])
def wrong_value_found(recording: Recording) -> Verdict:
    return see.mypy_objects(
        recording,
        WRONG_VALUE,
        cause="wrong-value-found.hint-too-wide",
        because="The hint of this argument allows more than the robot can use, or there is no hint.",
        try_this='Write float for the level, and Literal["operational", "error"] for the word.',
    )


@criterion(points=1, title="Every number arrives as that number, a whole one too", needs=[program_runs])
def numbers_arrive(recording: Recording) -> Verdict:
    found, arrived = outcomes(recording), see.values(recording, BATTERY)
    if not found:
        return never_called()
    expected = "42.0, 55.25 and 0.0 on /robot/battery after send_battery of 42, 55.25 and 0.0"
    for call, number in NUMBER_CALLS.items():
        if call == ZERO and found.get(call) != "returned":
            return zero_refused(found.get(call), expected)
        if found.get(call) != "returned":
            return see.failed(
                "numbers-arrive.refused",
                f"{call} raised {found.get(call)}",
                expected,
                "A whole number is a number, and mypy accepts an int where a float is expected. But "
                "isinstance(level, float) is False for an int.",
                "Accept both with isinstance(level, (int, float)), and pass float(level) to the message.",
            )
        if not set(NUMBERS).intersection(arrived):
            return see.failed(
                "numbers-arrive.not-sent",
                f"{call} sent nothing that arrived on {BATTERY.name}",
                expected,
                "The message was sent on another topic, or not at all.",
                f"Publish it with the publisher for {BATTERY.name!r}.",
            )
        if number not in arrived:
            what = "0.0" if zeros_too_many(recording) else f"nothing that arrived as {number}"
            return see.failed(
                "numbers-arrive.not-converted",
                f"{call} sent {what}",
                expected,
                "mypy accepts an int where a float is expected. The message does not: this build sends 0.0 for "
                "it, and reports no error. The Ubuntu packages may abort the program instead.",
                "Pass float(level) to the message.",
            )
    return see.passed("42 arrived as 42.0, 55.25 as 55.25, 0.0 as 0.0")


@criterion(
    points=2,
    title="At run time, too, a wrong value or message raises an error, and nothing is sent",
    needs=[program_runs],
)
def refuses_wrong_types(recording: Recording) -> Verdict:
    if not outcomes(recording):
        return never_called()
    return see.all_of(refuses_wrong_numbers(recording), refuses_wrong_messages(recording))


@criterion(
    points=1,
    title="At run time, too, any other word raises an error, and is not sent",
    needs=[program_runs],
)
def refuses_wrong_words(recording: Recording) -> Verdict:
    if not outcomes(recording):
        return never_called()
    wrong = sent_among(recording, STATUS, NEVER_SENT)
    accepted = first_accepted(recording, WRONG_WORDS)
    wrong.sort(key=lambda word: repr(word) not in (accepted or ""))
    sent = f'"{wrong[0]}" was sent on /robot/status' if wrong else ""
    if accepted is None:
        return refused(recording, WRONG_WORDS, sent)
    return see.failed(
        "refuses-wrong-words.accepted",
        raised_nothing(accepted, sent),
        errors_expected(WRONG_WORDS),
        "A Literal is a hint like any other: at run time it stops nothing. A word may come from a file or a "
        "network, which mypy never sees.",
        "Before publishing: if word not in get_args(Status): raise ValueError(...)",
    )


def zero_refused(raised: str | None, expected: str) -> Verdict:
    """The other numbers were sent; 0.0 raised an error."""
    return see.failed(
        "numbers-arrive.zero-refused",
        f"{ZERO} raised {raised}",
        expected,
        "0.0 is a number as well: the charge of an empty battery. In a condition it counts as false, like None.",
        "Check whether it is a number: isinstance(level, (int, float)).",
    )


# --- what the driver sent, and what became of its calls -----------------------------------------------------


def by_itself(recording: Recording) -> Recording:
    """The recording without what the driver sent through the node."""
    asked = [word.t for word in see.said(recording, "/driver/go")]
    topics = dict(recording.topics)
    for one, foreign in ((BATTERY, NUMBERS), (STATUS, WORDS)):
        seen = recording.topic(one.name)
        own = tuple(
            arrival
            for arrival in seen.arrivals
            if arrival.value.get("data") not in foreign
            or not any(moment - JUST_BEFORE_S <= arrival.t < moment + SOON_S for moment in asked)
        )
        topics[one.name] = replace(seen, arrivals=own)
    return replace(recording, topics=topics)


def outcomes(recording: Recording) -> dict[str, str]:
    """What became of each call of the driver: "returned", or the error; empty when it never came to its calls."""
    lines = [line for text in see.driver_reports(recording, REPORT) for line in text.splitlines()]
    return dict(line.split("\t", 1) for line in lines if "\t" in line)


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
    others_refused = all(found.get(call) != "returned" for call in WRONG_NUMBERS if call != DIGITS)
    if others_refused and found.get(DIGITS) == "returned":
        return see.failed(
            "refuses-wrong-types.text-read",
            saw,
            expected,
            "float('87.5') turns a text into a number. It is still a text, and the next one may be '87 %'. "
            "A caller's mistake should not be accepted by chance.",
            hint,
        )
    return see.failed(
        "refuses-wrong-types.value-accepted",
        saw,
        expected,
        "Hints are for readers; Python ignores them at run time. This build of ROS does not check either: it "
        "sends anything that is not a float as 0.0.",
        hint,
    )


def number_sent(recording: Recording) -> str:
    """What arrived because of a wrong number, in words; empty if nothing did."""
    found = outcomes(recording)
    wrong = [*sent_among(recording, BATTERY, (87.5,)), *[0.0] * zeros_too_many(recording)]
    # An int that became 0.0 is the business of numbers_arrive.
    if found.get("send_battery(42)") == "returned" and 42.0 not in see.values(recording, BATTERY):
        wrong = [value for value in wrong if value != 0.0 or "returned" in map(found.get, WRONG_NUMBERS)]
    return f"{wrong[0]} was sent on /robot/battery" if wrong else ""


def refuses_wrong_messages(recording: Recording) -> Verdict:
    """A publisher that is given a message of another type raises an error."""
    accepted = first_accepted(recording, WRONG_MESSAGES)
    if accepted is None:
        return refused(recording, WRONG_MESSAGES, "")
    if accepted in WRONG_MESSAGES[2:]:
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
        "rclpy refuses such a message with a TypeError. Your code catches that error.",
        "Do not catch the error: the caller must see it.",
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
