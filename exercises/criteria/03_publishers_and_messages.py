"""How exercise 03 is judged: each call of publish_level, and what went out on /robot/battery because of it."""

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion, failed, passed, topic, watching
from workbook.criteria.mishaps import find_mishap
from workbook.criteria.phrasing import count, listing, number

BATTERY = topic("/robot/battery", Float32)
REPORT = topic("/driver/report", String)
TOLERANCE = 1e-5
NO_CALL = "no call at all"

FLOATS = {"87.25": 87.25, "99.9": 99.9, "0.1": 0.1, "100.0": 100.0, "42.5": 42.5}
EMPTY = {"0.0": 0.0}
OTHER_NUMBERS = {
    "64": 64.0,
    "0": 0.0,
    "np.float32(12.5)": 12.5,
    "np.float64(33.25)": 33.25,
    "np.int64(7)": 7.0,
}
NO_NUMBERS = ("None", "'full'", "[50.0]")
LOOK_LIKE_NUMBERS = ("True", "'50'")
NOT_FINITE = ("nan", "inf")
MEANT = {**FLOATS, **EMPTY, **OTHER_NUMBERS}
KINDS = {
    "64": "an int",
    "0": "an int",
    "'full'": "a text",
    "[50.0]": "a list",
    "True": "a bool",
    "'50'": "a text",
}
CALLS = (
    "87.25", "99.9", "0.1", "64", "None", "np.float32(12.5)", "True", "0.0", "'full'", "np.float64(33.25)",
    "nan", "100.0", "'50'", "np.int64(7)", "[50.0]", "0", "inf", "42.5",
)  # fmt: skip

WATCH = watching(
    wall_seconds=4.5, script=[see.says("/driver/calls", String, [(0.0, "\n".join(CALLS))], "latched")]
)

_BEGINS = re.compile(r"call (?P<number>\d+): publish_level\((?P<value>.*)\)")
_ENDS = re.compile(r"call (?P<number>\d+) (?P<how>returned|raised)(?: (?P<error>.*))?", re.DOTALL)


def as_float(value: float) -> str:
    """A number as Python writes a float: 64.0, 99.9, nan."""
    return f"{value:.1f}" if value.is_integer() else number(value)


@dataclass
class Call:
    """One call of publish_level: its argument, how it came back (None: not at all), and what went out meanwhile."""

    value: str
    how: str | None = None
    error: str = ""
    sent: list[float] = field(default_factory=list)

    @property
    def words(self) -> str:
        """The call as one writes it, and what kind of value it was."""
        kind = KINDS.get(self.value)
        return f"publish_level({self.value})" + (f", {kind}," if kind else "")

    @property
    def outcome(self) -> str:
        """How it came back and what went out, in words."""
        out = f"{listing([as_float(one) for one in self.sent])} went out" if self.sent else "nothing went out"
        if self.how == "raised":
            return f"raised {self.error}, and {out}"
        return f"came back without an error, and {out}"


def reports(recording: Recording) -> list[str]:
    """What the driver said, in order."""
    return [str(one) for one in see.values(recording, REPORT)]


def calls_made(recording: Recording) -> dict[str, Call]:
    """The calls by their argument. A message belongs to the call that was announced last before it was published."""
    heard = [(one.published, 0, one.value["data"]) for one in recording.topic(REPORT.name).arrivals]
    heard += [(one.published, 1, one.value["data"]) for one in recording.topic(BATTERY.name).arrivals]
    latest = Call(NO_CALL)
    made = {NO_CALL: latest}
    for _, is_level, data in sorted(heard, key=lambda one: one[:2]):
        if is_level:
            latest.sent.append(data)
        elif begins := _BEGINS.fullmatch(data):
            latest = made[begins["value"]] = Call(begins["value"])
        elif ends := _ENDS.fullmatch(data):
            latest.how, latest.error = ends["how"], ends["error"] or ""
    return made


def first_that(recording: Recording, values: Iterable[str], bad: Callable[[Call], bool]) -> Call | None:
    """The first of these calls that is bad."""
    made = calls_made(recording)
    return next((made[value] for value in values if bad(made[value])), None)


def right(call: Call) -> bool:
    """The call sent the number that it was given, once, and came back."""
    return (
        call.how == "returned" and len(call.sent) == 1 and abs(call.sent[0] - MEANT[call.value]) <= TOLERANCE
    )


def refused(call: Call) -> bool:
    """The call raised an error and sent nothing."""
    return call.how == "raised" and not call.sent


def lost_number(call: Call) -> Verdict:
    """Why a number did not arrive."""
    meant = as_float(MEANT[call.value])
    expected = f"{meant} on {BATTERY.name}, once, within {TOLERANCE:g}"
    saw = f"{call.words} {call.outcome}"
    if call.how == "raised":
        because = "An error came out of your method, although it was given a number."
        hint = "Read the error: it names what went wrong in your method."
        if call.error.startswith("TypeError: Expected <class"):
            because = "publish() was given something that is not a Float32 message."
            hint = "Make the message first: self.battery_publisher.publish(Float32(data=...))."
        elif call.value in OTHER_NUMBERS:
            because = "Your test refuses more than it must: this is a number, only not a Python float."
            hint = (
                "Ask for a number of any kind (numbers.Real knows NumPy's as well), then send float(level)."
            )
        elif call.value in EMPTY:
            because = "Zero counts as false in Python, so `if not level` takes an empty battery for no value."
            hint = "Ask for what you mean, for example `if level is None`."
        return failed(saw, expected, because, hint)
    if len(call.sent) > 1:
        return failed(
            saw,
            expected,
            "Something publishes besides the one message of this call: a second publish(), or a timer.",
            "Publish once in publish_level, and nowhere else.",
        )
    if not call.sent:
        return failed(
            saw,
            expected,
            "publish() was not reached, or its publisher was made only now, and nobody is connected to it yet.",
            "Create the publisher in __init__, and call its publish() in every call with a number.",
        )
    if call.value in OTHER_NUMBERS and call.sent[0] == 0.0:
        return failed(
            saw,
            expected,
            "A float32 field wants a Python float. An int or a np.float32 is sent as 0.0 by stock ROS, without a word.",
            "Convert at the door: Float32(data=float(level)).",
        )
    return failed(
        saw,
        expected,
        "The number is changed on its way: rounded, scaled, or turned into another type.",
        "Send the number as it came, in percent. Round where it is shown, not where it is sent.",
    )


def not_refused(call: Call) -> Verdict:
    """Why a value that is no charge was not refused."""
    saw = f"{call.words} {call.outcome}"
    expected = "an error for the one who called, and nothing on the wire"
    if call.how == "raised":
        return failed(
            saw,
            expected,
            "The error comes too late: the message had gone out by then.",
            "Look at the value first, and publish in the last line of the method.",
        )
    if not call.sent:
        return failed(
            saw,
            expected,
            "The value is dropped in silence (return, pass, or only a line in the log). Whoever called believes that "
            "the charge was reported.",
            "raise TypeError or ValueError, with the value in its text.",
        )
    if call.value in NOT_FINITE:
        because = f"{call.value} is a Python float, so float() and isinstance() let it pass."
        if 0.0 <= call.sent[0] <= 100.0:
            because = (
                "A comparison with nan is always False, so min() and max() turn it into one of the limits."
            )
        return failed(saw, expected, because, "Ask math.isfinite(level), and raise ValueError if it is not.")
    if call.value in LOOK_LIKE_NUMBERS:
        because = (
            "float('50') is 50.0: float() reads texts. Whoever sends a text has a bug that you would hide."
        )
        if call.value == "True":
            because = "In Python a bool is a kind of int, so True becomes 1.0: a battery of one percent."
        if call.sent[0] == 0.0:
            because = "A float32 field wants a Python float. Anything else is sent as 0.0 by stock ROS, without a word."
        return failed(
            saw, expected, because, "Look at the type, before you convert: is it a number, and no bool?"
        )
    return failed(
        saw,
        expected,
        "A message is sent for something that is no number. Stock ROS sends 0.0 for what is no float, or your method "
        "does.",
        "raise TypeError if the value is no number, before you make the message.",
    )


def all_right(recording: Recording, values: Iterable[str], praise: str) -> Verdict:
    """All of these numbers arrived."""
    bad = first_that(recording, values, lambda call: not right(call))
    return passed(praise) if bad is None else lost_number(bad)


def all_refused(recording: Recording, values: Iterable[str], praise: str) -> Verdict:
    """All of these values were refused."""
    bad = first_that(recording, values, lambda call: not refused(call))
    return passed(praise) if bad is None else not_refused(bad)


@criterion(points=0, title="Your program runs and its node is on the graph")
def program_runs(recording: Recording) -> Verdict:
    return see.program_runs(recording)


@criterion(points=0, title="BatteryPublisher() can be made, and every call comes back", needs=[program_runs])
def calls_come_back(recording: Recording) -> Verdict:
    said = reports(recording)
    expected = f"a class BatteryPublisher, and {len(CALLS)} calls of its publish_level that return or raise"
    trouble = next((one.removeprefix("not made: ") for one in said if one.startswith("not made: ")), None)
    mishap = find_mishap(recording.process.log, recording.process.program)
    if trouble is not None:
        if "raised" in trouble and mishap is not None:
            return failed(f"{mishap.where}{trouble}", expected, mishap.because, mishap.try_this)
        return failed(
            f"{trouble} in your file",
            expected,
            "It is missing, has another name, or is indented into the wrong place.",
            "Keep the names of the starter: class BatteryPublisher, method publish_level(self, level).",
        )
    if "done" in said:
        return passed(f"{count(len(CALLS), 'call')} made")
    begun = [found["value"] for one in said if (found := _BEGINS.fullmatch(one))]
    if recording.process.ended_by == "itself":
        where = f"publish_level({begun[-1]})" if begun else "the first call"
        return failed(
            f"the program ended by itself at {where} (exit code {recording.process.exit})",
            expected,
            "Something ends the whole program, sys.exit() for example. The robot would lose all its nodes at once.",
            "raise an error instead, and let the one who called decide.",
        )
    if begun:
        return failed(
            f"publish_level({begun[-1]}) never came back",
            expected,
            "The method waits for ever: a spin, a loop, or a sleep. To publish, nothing has to spin.",
            "Let the method publish and return.",
        )
    return failed(
        "your file runs on and on by itself, so nobody comes to call publish_level",
        expected,
        "Your file is imported. What stands at its left margin runs at once, and a spin there has no end.",
        "Leave only the class, or put the rest under `if __name__ == '__main__':`.",
    )


@criterion(points=1, title="/robot/battery carries Float32", needs=[calls_come_back])
def battery_topic(recording: Recording) -> Verdict:
    return see.publishes(recording, BATTERY)


@criterion(points=2, title="Floats arrive as they are, each of them once", needs=[battery_topic])
def floats_arrive(recording: Recording) -> Verdict:
    return all_right(recording, FLOATS, f"{len(FLOATS)} floats arrived within {TOLERANCE:g}")


@criterion(points=1, title="An empty battery arrives: 0.0, when it is meant", needs=[floats_arrive])
def zero_arrives(recording: Recording) -> Verdict:
    return all_right(recording, EMPTY, "0.0 arrived as 0.0")


@criterion(points=2, title="Other numbers arrive, too: int, np.float32, np.float64", needs=[floats_arrive])
def numbers_arrive(recording: Recording) -> Verdict:
    return all_right(
        recording, OTHER_NUMBERS, "int, np.float32, np.float64 and np.int64 arrived as their number"
    )


@criterion(points=1, title="None, a word and a list are refused with an error", needs=[floats_arrive])
def no_number_refused(recording: Recording) -> Verdict:
    return all_refused(recording, NO_NUMBERS, "None, 'full' and [50.0] raised an error")


@criterion(points=1, title="True and '50' are refused, although float() takes them", needs=[floats_arrive])
def look_alikes_refused(recording: Recording) -> Verdict:
    return all_refused(recording, LOOK_LIKE_NUMBERS, "True and '50' raised an error")


@criterion(points=1, title="nan and inf are refused, although they are floats", needs=[floats_arrive])
def not_finite_refused(recording: Recording) -> Verdict:
    return all_refused(recording, NOT_FINITE, "nan and inf raised an error")


@criterion(points=1, title="No 0.0 on the wire that nobody meant", needs=[floats_arrive])
def no_invented_zero(recording: Recording) -> Verdict:
    made = calls_made(recording)
    invented = [call.value for call in made.values() if 0.0 in call.sent and MEANT.get(call.value) != 0.0]
    if not invented:
        return passed("0.0 went out only where it was meant")
    return failed(
        f"0.0 went out for {listing(invented)}",
        "0.0 only for a battery that is empty",
        "A listener cannot tell this zero from a real one. It will stop the robot, or send it home, for nothing.",
        "Convert numbers with float(level), raise an error for all the rest, and have no 0.0 to fall back on.",
    )
