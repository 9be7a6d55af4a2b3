"""How exercise 07 is judged: mypy reads the node and code that uses it, and a driver uses it while it runs."""

from dataclasses import replace

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import Recording, Topic, Verdict, criterion, probe, topic, watching

BATTERY = topic("/robot/battery", Float32, hz=1.0)
STATUS = topic("/robot/status", String, hz=0.5)
REPORT = topic("/driver/report", String)
WATCH = watching(
    robot_seconds=12,
    script=[see.says("/driver/go", String, [(2.6, "go"), (8.6, "go")])],  # one in each half of the watch
)

# What the driver sends, or what becomes of it; the node itself sends other values.
NUMBERS = (42.0, 55.25, 87.5, 0.0)
WORDS = ("error", "operatoinal", "3", "")
SOON_S = 1.5
NUMBER_CALLS = {"send_battery(42)": 42.0, "send_battery(55.25)": 55.25}
WRONG_NUMBERS = ("send_battery('full')", "send_battery('87.5')", "send_battery(None)")
WRONG_WORDS = ("send_status('operatoinal')", "send_status(3)")
WRONG_MESSAGES = ("battery_publisher.publish(String())", "status_publisher.publish(Float32())")

RIGHT_USE = probe(
    "right use of your node",
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
    """,
)


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
            or not any(moment - 0.01 <= arrival.t < moment + SOON_S for moment in asked)
        )
        topics[one.name] = replace(seen, arrivals=own)
    return replace(recording, topics=topics)


def outcomes(recording: Recording) -> dict[str, str]:
    """What became of each call of the driver."""
    lines = [line for text in see.values(recording, REPORT) for line in str(text).splitlines()]
    return dict(line.split("\t", 1) for line in lines if "\t" in line)


def not_called(recording: Recording) -> Verdict | None:
    """A failed verdict when the driver never came to its calls."""
    if outcomes(recording):
        return None
    return see.failed(
        "your node could not be used from outside: the code around it never got its turn",
        "a module that can be imported without starting to spin",
        "The file starts to spin as soon as it is imported, or a callback never returns.",
        'Keep `if __name__ == "__main__":` before main() at the end of the file.',
    )


def garbled(recording: Recording, one: Topic, intended: tuple[object, ...]) -> list[object]:
    """Values on a topic that nobody meant to send."""
    return [value for value in see.values(recording, one) if value in intended]


def refuses(recording: Recording, calls: tuple[str, ...], sent: str, because: str, try_this: str) -> Verdict:
    """Each of these calls raises an error; `sent` says what arrived nevertheless, if something did."""
    expected = f"an error from each of {len(calls)} wrong calls, and nothing sent"
    found = outcomes(recording)
    for call in calls:
        if found.get(call, "returned") == "returned":
            also = f", and {sent}" if sent else ""
            return see.failed(f"{call} raised nothing{also}", expected, because, try_this)
    if sent:
        return see.failed(
            f"{calls[0]} raised {found[calls[0]].split(':')[0]}, but {sent}",
            expected,
            "The message was on its way already when the error came.",
            "Look at the value first, and publish when nothing is wrong with it.",
        )
    return see.passed(f"{calls[0]} raises {found[calls[0]]}")


@criterion(points=0, title="Your program runs and its node is on the graph")
def program_runs(recording: Recording) -> Verdict:
    return see.program_runs(recording)


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


@criterion(points=0, title="mypy has nothing against right use of your node", needs=[program_runs])
def right_use(recording: Recording) -> Verdict:
    return see.mypy_accepts(recording, RIGHT_USE)


@criterion(
    points=2, title="mypy objects when a publisher gets a message of the wrong type", needs=[right_use]
)
def wrong_message_found(recording: Recording) -> Verdict:
    return see.mypy_objects(
        recording,
        WRONG_MESSAGE,
        because="To mypy this attribute is rclpy's own Publisher, which does not know its message type, or Any. Both "
        "take every message.",
        try_this="Annotate the attributes with a Protocol that has a publish method for one type: "
        "self.battery_publisher: Sends[Float32] = ...",
    )


@criterion(points=1, title="mypy objects to a wrong value and to a misspelled word", needs=[right_use])
def wrong_value_found(recording: Recording) -> Verdict:
    return see.mypy_objects(
        recording,
        WRONG_VALUE,
        because="The hint of this argument is wider than what the robot can use, or there is none.",
        try_this='float for the level; for a word out of two Literal["operational", "error"].',
    )


@criterion(points=1, title="Every number arrives as that number, a whole one too", needs=[program_runs])
def numbers_arrive(recording: Recording) -> Verdict:
    missing = not_called(recording)
    if missing is not None:
        return missing
    expected = "42.0 and 55.25 on /robot/battery after send_battery(42) and send_battery(55.25)"
    found, arrived = outcomes(recording), see.values(recording, BATTERY)
    for call, number in NUMBER_CALLS.items():
        if found.get(call) != "returned":
            return see.failed(
                f"{call} raised {found.get(call)}",
                expected,
                "A whole number is a number, and mypy lets an int pass where a float is asked for. "
                "isinstance(level, float) alone is False for it.",
                "Accept both, isinstance(level, (int, float)), and hand float(level) to the message.",
            )
        if not set(NUMBERS).intersection(arrived):
            return see.failed(
                f"{call} sent nothing that arrived on {BATTERY.name}",
                expected,
                "The message went to another topic, or nowhere.",
                f"Publish it with the publisher of {BATTERY.name!r}.",
            )
        if number not in arrived:
            what = "0.0" if 0.0 in arrived else f"nothing that arrived as {number}"
            return see.failed(
                f"{call} sent {what}",
                expected,
                "mypy lets an int pass where a float is asked for. The message does not: stock ROS sends 0.0 for it, "
                "without a word.",
                "Hand float(level) to the message.",
            )
    return see.passed("42 arrived as 42.0, 55.25 as 55.25")


@criterion(
    points=2,
    title="At run time, too, a wrong value or message raises, and nothing is sent",
    needs=[program_runs],
)
def refuses_wrong_types(recording: Recording) -> Verdict:
    missing = not_called(recording)
    if missing is not None:
        return missing
    found = outcomes(recording)
    wrong = garbled(recording, BATTERY, (0.0, 87.5))
    # An int that became 0.0 is the business of numbers_arrive.
    if found.get("send_battery(42)") == "returned" and 42.0 not in see.values(recording, BATTERY):
        wrong = [value for value in wrong if value != 0.0 or "returned" in map(found.get, WRONG_NUMBERS)]
    sent = f"{wrong[0]} was sent on /robot/battery" if wrong else ""
    only_digits = all(found.get(call) != "returned" for call in WRONG_NUMBERS if "87.5" not in call)
    if only_digits and found.get("send_battery('87.5')") == "returned":
        because = (
            "float('87.5') makes a number of a text. It is still a text, and the next one says '87 %': what a caller "
            "sends by mistake should not pass by luck."
        )
    else:
        because = (
            "Hints are for readers; Python does not look at them when it runs. Stock ROS does not look either: "
            "what is no float is sent as 0.0."
        )
    return see.all_of(
        refuses(
            recording,
            WRONG_NUMBERS,
            sent,
            because,
            "Before publishing: if not isinstance(level, (int, float)): raise TypeError(...)",
        ),
        refuses(
            recording,
            WRONG_MESSAGES,
            "",
            "rclpy refuses such a message with a TypeError. Something of yours stands in between and swallows it.",
            "Let the error pass: the caller has to learn of it.",
        ),
    )


@criterion(
    points=1,
    title="At run time, too, a word that is not agreed raises, and is not sent",
    needs=[program_runs],
)
def refuses_wrong_words(recording: Recording) -> Verdict:
    missing = not_called(recording)
    if missing is not None:
        return missing
    wrong = garbled(recording, STATUS, ("operatoinal", "3", ""))
    return refuses(
        recording,
        WRONG_WORDS,
        f'"{wrong[0]}" was sent on /robot/status' if wrong else "",
        "A Literal is a hint like any other: it stops nobody at run time, and a word may come from a file or a network "
        "that mypy has never seen.",
        "Before publishing: if word not in get_args(Status): raise ValueError(...)",
    )
