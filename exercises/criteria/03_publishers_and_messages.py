"""How exercise 03 is judged: each call of publish_level, and what went out on /robot/battery because of it."""

import re
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from itertools import pairwise
from random import Random

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import DriverCall, Recording, Verdict, criterion, program_runs, topic, watching

BATTERY = topic("/robot/battery", Float32)
REPORT = topic("/driver/report", String, signed=True)
TOLERANCE = 1e-5  # what 32 bits make of a charge with a few decimals; the task names it

COUNT = 40  # calls
Kind = Callable[[str | None], bool]
"""Whether an argument, as Python writes it, is of a certain kind."""
BOOLS = ("True", "False")
NO_WORDS = ("full", "empty", "none", "ok")


def number_in(argument: str | None) -> float | None:
    """The number that must arrive for an argument, as Python writes it; None if it must be refused."""
    found = re.fullmatch(r"(?:np\.\w+\()?(\d+(?:\.\d+)?)\)?", argument or "")
    return float(found[1]) if found else None


def is_float(argument: str | None) -> bool:
    """Whether this is a float of Python, and not that of an empty battery."""
    return bool(re.fullmatch(r"\d+\.\d+", argument or "")) and not is_empty(argument)


def is_empty(argument: str | None) -> bool:
    return argument == "0.0"


def is_other_number(argument: str | None) -> bool:
    return number_in(argument) is not None and not is_float(argument) and not is_empty(argument)


def is_no_number(argument: str | None) -> bool:
    """Whether this is neither a number nor looks like one."""
    return bool(argument) and all(
        number_in(argument) is None and not kind(argument) for kind in (looks_like_number, is_not_finite)
    )


def looks_like_number(argument: str | None) -> bool:
    return argument in BOOLS or bool(re.fullmatch(r"' *\d+(\.\d+)? *'", argument or ""))


def is_not_finite(argument: str | None) -> bool:
    return bool(re.fullmatch(r"(np\.\w+\()?-?(nan|inf)\)?", argument or ""))


def is_wrong_type(argument: str | None) -> bool:
    return is_no_number(argument) or looks_like_number(argument)


def kind_of(argument: str | None) -> str:
    """What kind of value this is, in words, where that is not obvious."""
    kinds = {"'": "a string", "[": "a list", "(": "a tuple"}
    if argument in BOOLS:
        return "a bool"
    return "an int" if (argument or "").isdecimal() else kinds.get((argument or " ")[0], "")


def odd(rng: Random, low: int, high: int) -> int:
    """A number of two digits that does not end in 0, as those in texts do."""
    return 10 * rng.randint(low, high) + rng.randint(1, 9)


def drawn_arguments(rng: Random) -> list[str]:
    """The arguments of all calls: six numbers, then the others in any order, some of them together."""
    first, whole, small = f"{odd(rng, 5, 9)}.25", str(odd(rng, 1, 9)), str(rng.randint(2, 9))
    second = f"{odd(rng, 5, 9)}.{rng.choice('34679')}"
    begin = [first, second, second, f"0.{odd(rng, 1, 9)}", whole, f"np.float32({odd(rng, 1, 4)}.5)"]
    bools, texts = [*BOOLS], [f"'{10 * rng.randint(2, 9)}'", f"' {rng.randint(2, 9)}.5 '"]
    rng.shuffle(bools)
    rng.shuffle(texts)
    within = 10 * rng.randint(2, 9)
    long = f"{rng.randint(33, 98)}.{rng.randint(1000, 9999)}{rng.randint(1, 9)}"
    single = [
        bools[1], texts[1], "None", f"'{rng.choice(NO_WORDS)}'", "''", f"[{within}.0]", f"({within}.0,)", "[]",
        first, "100.0", "1.0", long, f"0.0000{rng.randint(2, 9)}", f"{odd(rng, 1, 4)}.5",
        whole, "0", "1", f"np.float64({odd(rng, 1, 9)}.25)", f"np.float16({rng.randint(33, 63)}.5)",
        f"np.int32({odd(rng, 1, 9)})", f"np.int8({odd(rng, 7, 9)})", "np.float32(0.0)",
    ]  # fmt: skip
    # A bool, an empty battery twice, and a text: what a zero leaves behind shows in what must be refused after it.
    units = [[bools[0], "0.0", "0.0", texts[0]], [f"np.int64({small})", small], *([one] for one in single)]
    rng.shuffle(units)
    # What is not finite comes behind numbers: a method that remembers wrong types may remember these, too, or not.
    not_finite = ["np.float32(nan)", "np.float64(-inf)", "np.float32(-inf)", "nan", "inf"]
    rng.shuffle(not_finite)
    first_minus = min(not_finite.index(f"np.{kind}(-inf)") for kind in ("float32", "float64"))
    not_finite.insert(rng.randint(0, first_minus), "-inf")
    places = rng.sample(
        [place for place, unit in enumerate(units) if number_in(unit[-1]) is not None], len(not_finite)
    )
    for place, argument in zip(sorted(places), not_finite, strict=True):
        units[place].append(argument)
    return [*begin, *(argument for unit in units for argument in unit)]


def fits(arguments: Sequence[str]) -> bool:
    """Whether each mistake shows as what it is in such a row of calls.

    A method that sends the last number again, instead of an error, must not seem to make another mistake; and what one
    call leaves behind must show in a float and in another number.
    """
    seen: list[str] = []
    sent = 0.0
    for argument in arguments:
        if (
            (is_not_finite(argument) and sent == 100.0)
            or (argument == "True" and sent == 1.0)
            or (is_empty(argument) and sent < 1.0 and not is_empty(seen[-1]))
            or (argument.startswith("0.0000") and sent == 0.0)
            or (is_no_number(argument) and sent == 0.0 and not any(map(is_no_number, seen)))
        ):
            return False
        number = number_in(argument)
        sent = sent if number is None else number
        seen.append(argument)
    after = {argument for before, argument in pairwise(arguments) if is_wrong_type(before)}
    first_look_alike = next(filter(looks_like_number, arguments))
    last_number = next(one for one in reversed(arguments) if number_in(one) is not None)
    return (
        first_look_alike in BOOLS
        and any(map(is_float, after))
        and any(map(is_other_number, after))
        and is_float(last_number)
        and sent > 1.0
    )


def drawn(rng: Random) -> list[see.Part]:
    """Numbers and misuse in turn, some twice in a row, some once more much later."""
    arguments = drawn_arguments(rng)
    while not fits(arguments):
        arguments = drawn_arguments(rng)
    return [see.publish("/driver/calls", String, [(0.0, "\n".join(arguments))], "latched")]


AT_ONCE = 4  # the driver makes this call right after the one before, and all others 0.06 s after it
EARLY = "sent before any call: "
NEVER_AWAITED = "publish_level' was never awaited"  # Python's warning in the log
MISTAKES = ("NameError", "AttributeError", "UnboundLocalError")

WATCH = watching(wall_seconds=5.0, script=drawn)


@criterion(points=0, title="BatteryPublisher() can be created, and every call returns", needs=[program_runs])
def calls_come_back(recording: Recording) -> Verdict:
    expected = f"a class BatteryPublisher, and {COUNT} calls of its publish_level that return or raise"
    said = see.driver_reports(recording, REPORT)
    trouble = next((one.removeprefix("not made: ") for one in said if one.startswith("not made: ")), None)
    if trouble is not None:
        return cannot_be_called(recording, trouble, expected)
    ordered = ordered_by_another(recording, "done" in said, expected)
    if ordered is not None:
        return ordered
    if "done" in said:
        return see.passed(f"{see.count(COUNT, 'call')} made")
    begun = [call.argument for call in calls(recording) if call.number]
    return stopped_short(recording, begun[-1] if begun else None, expected)


@criterion(points=1, title="/robot/battery carries Float32", needs=[calls_come_back])
def battery_topic(recording: Recording) -> Verdict:
    # The log holds the errors of the calls. They are judged one by one, and are no reason why a topic is missing.
    silent = replace(recording, process=replace(recording.process, log=""))
    return see.publishes(silent, BATTERY)


@criterion(points=0, title="A number passed to it is published", needs=[battery_topic])
def sends(recording: Recording) -> Verdict:
    numbers = [call for call in judged_calls(recording) if number_in(call.argument) is not None]
    if any(call.sent or call.later for call in numbers):
        return see.passed("numbers are published")
    if NEVER_AWAITED in recording.process.log:
        return see.failed(
            "number.coroutine",
            words(numbers[0]),
            f"{as_float(meant(numbers[0]))} on {BATTERY.name}, once, within {TOLERANCE:g}",
            "publish_level is declared with async. Calling it doesn't run its code: the call only creates a "
            "coroutine, which the driver doesn't await.",
            "Write def publish_level(self, level), without async.",
        )
    return why_not_arrived(numbers[0], numbers)


@criterion(points=2, title="Floats arrive unchanged, each of them once", needs=[sends])
def floats_arrive(recording: Recording) -> Verdict:
    verdict = all_arrived(recording, is_float, f"all floats arrived within {TOLERANCE:g}")
    before = [*at_the_start(recording), *calls(recording)[0].later]
    if before and verdict.ok:
        return see.failed(
            "floats-arrive.uncalled",
            f"{as_float(before[0])} was published before publish_level was called",
            "one message for each call with a number, and no others",
            "Something other than publish_level publishes: __init__, or a timer.",
            "Publish once in publish_level, and nowhere else.",
        )
    return verdict


@criterion(points=1, title="0.0 arrives when the battery is really empty", needs=[sends])
def zero_arrives(recording: Recording) -> Verdict:
    return all_arrived(recording, is_empty, "0.0 arrived as 0.0")


@criterion(points=2, title="Other numbers arrive, too: int and NumPy's", needs=[sends])
def numbers_arrive(recording: Recording) -> Verdict:
    return all_arrived(recording, is_other_number, "ints and NumPy numbers arrived with the right value")


@criterion(points=1, title="None, strings, a list, and a tuple are rejected with an error", needs=[sends])
def no_number_refused(recording: Recording) -> Verdict:
    return all_refused(recording, is_no_number, "None, words, a list, and a tuple raised an error")


@criterion(points=1, title="True and '50' are rejected, although float() accepts them", needs=[sends])
def look_alikes_refused(recording: Recording) -> Verdict:
    return all_refused(recording, looks_like_number, "bools and strings of digits raised an error")


@criterion(points=1, title="nan and inf are rejected, although they are floats", needs=[sends])
def not_finite_refused(recording: Recording) -> Verdict:
    return all_refused(recording, is_not_finite, "nan, inf, and -inf raised an error")


@criterion(points=1, title="No 0.0 is sent by mistake", needs=[sends])
def no_invented_zero(recording: Recording) -> Verdict:
    made = calls(recording)
    first_meant = min(
        (call.number for call in made if not is_other_than_zero(call) and call.number), default=0
    )
    at_start = ["nothing at all"] if 0.0 in at_the_start(recording) else []
    invented = at_start + [
        call.argument or "nothing at all"
        for call in made
        if (0.0 in call.sent and is_other_than_zero(call))
        or (0.0 in call.later and call.number < first_meant)
    ]
    if not invented:
        return see.passed("0.0 was published only for an empty battery")
    return see.failed(
        "no-invented-zero.sent",
        f"0.0 was published for {see.listing(list(dict.fromkeys(invented)))}",
        "0.0 only for an empty battery",
        "A subscriber can't distinguish this zero from a real one. It may stop the robot, or send it home, for no "
        "reason.",
        "Convert numbers with float(level), raise an error for everything else, and never use 0.0 as a default.",
    )


# --- the calls, and what went out because of each -----------------------------------------------------------


def calls(recording: Recording) -> list[DriverCall]:
    """All calls that were reported; the first one stands for the time before them."""
    return see.driver_calls(recording, REPORT, BATTERY)


def at_the_start(recording: Recording) -> list[float]:
    """What was sent when the node was made. Only the driver, in the same process, knows of that."""
    said = (one.removeprefix(EARLY) for one in see.driver_reports(recording, REPORT) if one.startswith(EARLY))
    return [float(one) for one in said]


def judged_calls(recording: Recording) -> list[DriverCall]:
    """The calls of which both reports arrived."""
    return [call for call in calls(recording) if call.number and call.complete]


def is_other_than_zero(call: DriverCall) -> bool:
    """Whether a 0.0 is none of what this call may send.

    That False is sent is judged with the bools, and that 0.1 is rounded with the floats.
    """
    number = number_in(call.argument)
    return call.complete and (number is None or number >= 1.0) and call.argument != "False"


def words(call: DriverCall) -> str:
    """The call as one writes it, and what kind of value it was, then how it came back and what went out."""
    kind = kind_of(call.argument)
    told = f"publish_level({call.argument})" + (f", {kind}," if kind else "")
    how = f"raised {call.error}" if call.how == "raised" else "returned without an error"
    sent = see.listing([as_float(one) for one in call.sent])
    return f"{told} {how}; published: {sent or 'nothing'}"


def all_arrived(recording: Recording, wanted: Kind, praise: str) -> Verdict:
    """All of these numbers arrived."""
    made = judged_calls(recording)
    bad = next((call for call in made if wanted(call.argument) and not arrived(call)), None)
    return see.passed(praise) if bad is None else why_not_arrived(bad, made)


def all_refused(recording: Recording, wanted: Kind, praise: str) -> Verdict:
    """All of these values were refused."""
    made = judged_calls(recording)
    bad = next((call for call in made if wanted(call.argument) and not refused(call, made)), None)
    return see.passed(praise) if bad is None else why_not_refused(bad, made)


def meant(call: DriverCall) -> float:
    """The number that the call must send."""
    return number_in(call.argument) or 0.0


def arrived(call: DriverCall) -> bool:
    """The call sent the number that it was given, once, and came back."""
    if call.how != "returned" or call.later or len(call.sent) != 1:
        return False
    return abs(float(call.sent[0]) - meant(call)) <= TOLERANCE


def refused(call: DriverCall, made: Sequence[DriverCall]) -> bool:
    """The call raised an error and sent nothing."""
    return call.how == "raised" and not call.sent and not strange(call, made)


def strange(call: DriverCall, made: Sequence[DriverCall]) -> list[float]:
    """What followed the call and repeats none of the numbers: who repeats these has lost the points for numbers."""
    numbers = {number for one in made if (number := number_in(one.argument)) is not None}
    return [one for one in call.later if all(abs(one - number) > TOLERANCE for number in numbers)]


def as_float(value: float) -> str:
    """A number as Python writes a float: 64.0, 99.9, nan."""
    return f"{value:.1f}" if value.is_integer() else f"{value:.7g}"


# --- why there were no calls, or not all of them ------------------------------------------------------------


def cannot_be_called(recording: Recording, trouble: str, expected: str) -> Verdict:
    """Why the driver could not begin."""
    if "BatteryPublisher.__init__() missing" in trouble:
        return see.failed(
            "calls-come-back.needs-arguments",
            trouble,
            expected,
            "Your class cannot be created without arguments. But other code creates it, as BatteryPublisher().",
            "Write def __init__(self) without more arguments, or give each of them a default.",
        )
    raised = see.failed_in_call(recording, trouble, expected) if "raised" in trouble else None
    return raised or see.failed(
        "calls-come-back.name-missing",
        f"{trouble} in your file",
        expected,
        "It's missing, has another name, or is indented incorrectly.",
        "Keep the names of the starter: class BatteryPublisher, method publish_level(self, level).",
    )


def ordered_by_another(recording: Recording, is_done: bool, expected: str) -> Verdict | None:
    """A failed verdict if the driver made other calls than the judge ordered, or fewer; None if it did not."""
    asked = [
        line for one in see.published(recording, "/driver/calls") for line in one.value["data"].splitlines()
    ]
    made = {
        call.number: call.argument for call in calls(recording) if call.argument is not None and call.number
    }
    others = [text for number, text in made.items() if asked[number - 1 : number] != [text]]
    if not asked or not (others or (is_done and made and max(made) < len(asked))):
        return None
    return see.failed(
        "calls-come-back.other-orders",
        f"publish_level({others[0]}) was called, but the judge didn't request it"
        if others
        else f"{see.count(len(made), 'call')} made, fewer than the judge requested",
        expected,
        "The judge publishes the requested calls on /driver/calls. But your program publishes there, too.",
        "Don't publish on /driver/calls.",
    )


def stopped_short(recording: Recording, latest: str | None, expected: str) -> Verdict:
    """Why the driver did not come to its end. `latest`: the argument of the last call that it began."""
    if recording.process.ended_by == "itself":
        where = "the first call" if latest is None else f"publish_level({latest})"
        return see.failed(
            "calls-come-back.program-ended",
            f"the program ended by itself at {where} (exit code {recording.process.exit})",
            expected,
            "Something ends the whole program, for example sys.exit(). A robot would lose all of this program's "
            "nodes at the same time.",
            "Raise an error instead, and let the caller decide what to do.",
        )
    if latest is not None:
        return see.failed(
            "calls-come-back.method-waits",
            f"publish_level({latest}) never returned",
            expected,
            "The method waits forever: in a spin, a loop, or a sleep. Publishing needs no spin.",
            "Let the method publish, and then return.",
        )
    return see.failed(
        "calls-come-back.import-does-not-end",
        "your file keeps running when it is imported, so publish_level was never called",
        expected,
        "The judge imports your file. Code at the left margin runs right away, and a spin there never ends.",
        "Keep only the class, or put the rest under `if __name__ == '__main__':`.",
    )


# --- why a number did not arrive ----------------------------------------------------------------------------


def why_not_arrived(call: DriverCall, made: list[DriverCall]) -> Verdict:
    """Why a number did not arrive. `made`: all calls."""
    expected = f"{as_float(meant(call))} on {BATTERY.name}, once, within {TOLERANCE:g}"
    saw = words(call)
    if call.how == "raised":
        return why_number_raised(call, made, saw, expected)
    if not call.sent:
        return why_dropped_at_once(call, made, saw, expected) or why_nothing_sent(call, made, saw, expected)
    if len(call.sent) > 1 or call.later:
        more = f"; {as_float(call.later[0])} followed after it had returned" if call.later else ""
        return see.failed(
            "number.sent-again",
            f"{saw}{more}",
            expected,
            "Something publishes more than the one message of this call: a second publish(), or a timer.",
            "Publish once in publish_level, and nowhere else.",
        )
    return why_changed(call, made, saw, expected)


def why_dropped_at_once(call: DriverCall, made: list[DriverCall], saw: str, expected: str) -> Verdict | None:
    """Why nothing was sent in the call that came at once after another, and in the next one again; else None."""
    after = next(
        (one for one in made if one.number > call.number and number_in(one.argument) is not None), None
    )
    if call.number != AT_ONCE or after is None or not arrived(after):
        return None
    return see.failed(
        "number.dropped-soon-after",
        saw,
        expected,
        "This call was made a few milliseconds after the previous one. The previous number and the next one "
        "arrived. So the method drops or delays a number that follows too soon.",
        "Send each number in its own call, no matter how much time has passed.",
    )


def why_nothing_sent(call: DriverCall, made: list[DriverCall], saw: str, expected: str) -> Verdict:
    """Why a call with a number came back, and nothing had gone out."""

    def fail(cause: str, because: str, try_this: str) -> Verdict:
        return see.failed(cause, saw, expected, because, try_this)

    numbers = [one for one in made if number_in(one.argument) is not None]
    went_well, later = (
        [one for one in numbers if arrived(one)],
        [one for one in numbers if one.number > call.number],
    )
    if any(one.later for one in numbers):
        return fail(
            "number.sent-later",
            "The method stores the number, and something else publishes it: a timer, or the next call. Until then, "
            "subscribers have an outdated number.",
            "Call publish() in publish_level itself.",
        )
    if later and sends_what_was_before(call, later[0]):
        return why_one_behind(saw, expected)
    if only_after_errors(made):
        return fail(
            "number.dropped-after-error",
            "Only numbers that follow an error are lost, so the method stores the error.",
            "Treat every call the same, no matter what the previous calls were.",
        )
    repeated = any(one.number < call.number and meant(one) == meant(call) for one in went_well)
    if repeated and any(arrived(one) for one in later):
        return why_repeat_dropped(saw, expected)
    if meant(call) == 0.0:
        return why_zero_dropped(saw, expected)
    if went_well and later and not any(one.sent for one in later):
        return why_it_stops(saw, expected, len(went_well))
    return fail(
        "number.not-sent",
        "publish() was not reached. Or the publisher was created in this call, so no subscription is connected to "
        "it yet.",
        "Create the publisher in __init__, and call its publish() in every call with a number.",
    )


def why_repeat_dropped(saw: str, expected: str) -> Verdict:
    """Why a number that was sent before is not sent again."""
    return see.failed(
        "number.repeat-dropped",
        saw,
        expected,
        "This number was published before, and the method doesn't publish it again. But it was measured again, and "
        "subscribers can't know that without a message.",
        "Publish each number, no matter what was published before.",
    )


def why_it_stops(saw: str, expected: str, arrived_before: int) -> Verdict:
    """Why nothing goes out from one call on. `arrived_before`: how many numbers had arrived until then."""
    return see.failed(
        "number.stops",
        saw,
        expected,
        "From this call on, nothing is published, so the method depends on earlier calls. Before it, "
        f"{see.count(arrived_before, 'number')} arrived.",
        "Treat every call the same, no matter what the previous calls were.",
    )


def sends_what_was_before(before: DriverCall, call: DriverCall) -> bool:
    """Whether a call sends the number of the call with a number before it, and not its own."""
    return bool(call.sent) and meant(before) != meant(call) and abs(call.sent[0] - meant(before)) <= TOLERANCE


def why_one_behind(saw: str, expected: str) -> Verdict:
    """Why a number goes out one call too late."""
    return see.failed(
        "number.one-behind",
        saw,
        expected,
        "Each call publishes the previous call's number, because the message is published before the new number is "
        "stored.",
        "Create the message from this call's argument.",
    )


def why_zero_dropped(saw: str, expected: str) -> Verdict:
    """Why nothing went out for an empty battery."""
    return see.failed(
        "number.zero-dropped",
        saw,
        expected,
        "Zero counts as false in Python, so `if level:` skips an empty battery.",
        "Don't test whether level is true. Test whether it's a number.",
    )


def why_changed(call: DriverCall, made: list[DriverCall], saw: str, expected: str) -> Verdict:
    """Why another number went out than the call was given."""

    def fail(cause: str, because: str, try_this: str) -> Verdict:
        return see.failed(cause, saw, expected, because, try_this)

    sent, number = float(call.sent[0]), meant(call)
    if is_other_number(call.argument) and sent == 0.0:
        return fail(
            "number.not-converted",
            "A float32 field needs a Python float. This build sends an int or a np.float32 as 0.0, without an "
            "error. The Ubuntu packages may abort the program instead.",
            "Convert the number when you create the message: Float32(data=float(level)).",
        )
    if sent and abs(100.0 * sent - number) <= 100.0 * TOLERANCE:
        return fail(
            "number.fraction",
            "The number is divided by 100. The topic carries percentages, so a subscriber would assume that the "
            "battery is empty.",
            "Publish the number unchanged.",
        )
    before = [one for one in made if one.number < call.number and number_in(one.argument) is not None]
    if before and sends_what_was_before(before[-1], call):
        return why_one_behind(saw, expected)
    if any(abs(round(number, digits) - sent) <= TOLERANCE for digits in range(5)) or int(number) == sent:
        return fail(
            "number.rounded",
            "Decimals are cut off, rounded, or ignored, because of round(), int(), a condition, or a type with "
            "fewer digits.",
            "Publish the number unchanged. Round it where it's displayed, not where it's published.",
        )
    if any(one.sent and abs(one.sent[0] - sent) > TOLERANCE for one in made if one.argument == call.argument):
        return why_differently(saw, expected)
    return fail(
        "number.changed",
        "The number is changed before it's published: scaled, limited, or converted to another type.",
        "Publish the number unchanged, in percent.",
    )


def why_differently(saw: str, expected: str) -> Verdict:
    """Why one argument was sent as different numbers."""
    return see.failed(
        "number.depends-on-earlier",
        saw,
        expected,
        "In another call, the same argument was published as another number. So the published number depends on "
        "earlier calls: a mean, a filter, or a limit on the change between numbers.",
        "Publish this call's number unchanged.",
    )


def why_number_raised(call: DriverCall, made: list[DriverCall], saw: str, expected: str) -> Verdict:
    """Why a call with a number raised an error."""

    def fail(cause: str, because: str, try_this: str) -> Verdict:
        return see.failed(cause, saw, expected, because, try_this)

    if call.error.startswith("TypeError: Expected <class"):
        return fail(
            "number.no-message-made",
            "publish() received something that isn't a Float32 message.",
            "Create the message first: self.battery_publisher.publish(Float32(data=...)).",
        )
    if call.error.startswith(MISTAKES):
        return fail(
            "number.mistake",
            "This error isn't raised by a check. It's a mistake in your method: a name that isn't defined.",
            "Find the name in the error message, and the line in the log.",
        )
    if went_well_before(call, made) or only_after_errors(made):
        return fail(
            "number.refused-later",
            "The same kind of call worked before, so the method stores something: an error, a count, or old values.",
            "Treat every call the same, no matter what the previous calls were.",
        )
    if meant(call) in (0.0, 1.0):
        return why_zero_raised(made, saw, expected)
    if is_other_number(call.argument):
        return fail(
            "number.refused",
            "Your check rejects too much: this is a number, although it isn't a Python float.",
            "Accept every kind of number (numbers.Real includes NumPy's), then send float(level).",
        )
    return why_float_raised(made, saw, expected)


def why_float_raised(made: list[DriverCall], saw: str, expected: str) -> Verdict:
    """Why a call with a float raised an error."""
    floats = [one for one in made if is_float(one.argument)]
    if all((one.how == "raised") == (meant(one) < 1.0) for one in floats):
        return see.failed(
            "number.small-refused",
            saw,
            expected,
            "Only charges below 1 % are rejected. But an almost empty battery is a valid measurement, too.",
            "Reject a value only if it isn't a finite number.",
        )
    return see.failed(
        "number.raised",
        saw,
        expected,
        "Your method raised an error, although it received a number.",
        "Read the error message: it tells what went wrong in your method.",
    )


def went_well_before(call: DriverCall, made: list[DriverCall]) -> bool:
    """Whether the same call arrived before, or all numbers did until some call after a refusal, and none from it on."""
    if any(one.number < call.number and one.argument == call.argument and arrived(one) for one in made):
        return True
    numbers = [one for one in made if number_in(one.argument) is not None]
    first_refusal = min(
        (one.number for one in made if number_in(one.argument) is None and refused(one, made)), default=0
    )
    first_lost = next((one.number for one in numbers if not arrived(one)), 0)
    return 1 < first_refusal < first_lost and all(
        arrived(one) == (one.number < first_lost) for one in numbers
    )


def only_after_errors(made: list[DriverCall]) -> bool:
    """Whether the numbers that did not arrive are just those that follow a refused call, or one of a certain kind."""
    numbers = [(before, one) for before, one in pairwise(made) if number_in(one.argument) is not None]
    lost = {one.number for _, one in numbers if not arrived(one)}
    kinds: tuple[Kind, ...] = (
        is_no_number,
        looks_like_number,
        is_wrong_type,
        is_not_finite,
        lambda argument: number_in(argument) is None,
    )
    for kind in kinds:
        after = {one.number for before, one in numbers if kind(before.argument) and before.how == "raised"}
        if lost <= after and len(after) - 1 <= len(lost) > 2:
            return True
    return False


def why_zero_raised(made: list[DriverCall], saw: str, expected: str) -> Verdict:
    """Why a call with 0 or 1 raised an error."""
    if all(call.how == "raised" for call in made if call.argument in ("0.0", "1.0")):
        return see.failed(
            "number.taken-for-bool",
            saw,
            expected,
            "In Python, 0 == False and 1 == True, so a comparison with a bool also matches these numbers.",
            "Check the type, not the value: isinstance(level, bool).",
        )
    if all(call.how != "raised" for call in made if call.argument == "0.0"):
        return see.failed(
            "number.int-refused",
            saw,
            expected,
            "Your check rejects too much: an int is a number, even if it's 0 or 1.",
            "Accept every kind of number (numbers.Real includes NumPy's), then send float(level).",
        )
    return see.failed(
        "number.zero-taken-for-missing",
        saw,
        expected,
        "Zero counts as false in Python, so `if not level` treats an empty battery as a missing value.",
        "Test for exactly what you mean, for example `if level is None`.",
    )


# --- why a value that is no charge was not refused ----------------------------------------------------------


def why_not_refused(call: DriverCall, made: list[DriverCall]) -> Verdict:
    """Why a value that is no charge was not refused."""
    saw, expected = words(call), "an error raised to the caller, and nothing sent"

    def fail(cause: str, because: str, try_this: str) -> Verdict:
        return see.failed(cause, saw, expected, because, try_this)

    before = [one for one in made if one.number < call.number and number_in(one.argument) is not None]
    last = next((one.sent[-1] for one in reversed(before) if one.sent), 0.0)
    if call.sent and 0.0 != last == call.sent[0]:
        return fail(
            "refusal.last-again",
            "That's the last published number. But a subscriber will assume that it was measured again.",
            "Don't publish anything for a rejected value.",
        )
    if call.how == "raised" and call.sent:
        return fail(
            "refusal.too-late",
            "The error is raised too late: the message was already published.",
            "Check the value first, and publish in the last line of the method.",
        )
    if not call.sent and strange(call, made):
        return why_sent_later(strange(call, made)[0], saw, expected)
    if not call.sent:
        return fail(
            "refusal.silent",
            "The value is dropped silently (return, pass, or only a line in the log). So the caller assumes that "
            "the charge was reported.",
            "Raise TypeError or ValueError, with the value in its message.",
        )
    if is_not_finite(call.argument) or looks_like_number(call.argument):
        why = why_not_finite_sent if is_not_finite(call.argument) else why_look_alike_sent
        return why(call, {one.argument for one in made if refused(one, made)}, saw, expected)
    return fail(
        "refusal.no-number-sent",
        "Your method publishes a message for something that isn't a number. Either this build of ROS sends 0.0 for "
        "it, or your method converts it to a number.",
        "Raise TypeError if the value isn't a number, before you create the message.",
    )


def why_sent_later(strange_one: float, saw: str, expected: str) -> Verdict:
    """Why something went out after a call that was to send nothing had come back."""
    return see.failed(
        "refusal.sent-later",
        f"{saw}; {as_float(strange_one)} followed after it had returned",
        expected,
        "Something other than publish_level publishes, for example a timer, or publish_level publishes after it "
        "has returned.",
        "Publish once in publish_level, and nowhere else.",
    )


def why_not_finite_sent(
    call: DriverCall, refused_ones: Collection[str | None], saw: str, expected: str
) -> Verdict:
    """Why a message went out for nan or inf."""
    hint = "Raise ValueError if math.isfinite(level) is False."

    def fail(cause: str, because: str) -> Verdict:
        return see.failed(cause, saw, expected, because, hint)

    if 0.0 <= call.sent[0] <= 100.0:
        return fail(
            "refusal.nan-limited",
            "A comparison with nan is always False, so min() and max() turn nan into one of the limits.",
        )
    if call.argument == "-inf" and "inf" in refused_ones:
        return fail("refusal.negative-infinity", "Your check rejects inf, but not -inf.")
    if str(call.argument).startswith("np.") and {"nan", "inf", "-inf"} <= set(refused_ones):
        return fail(
            "refusal.numpy-not-finite",
            "Your check covers only Python's floats, but NumPy has nan and inf, too.",
        )
    return fail(
        "refusal.not-finite-sent",
        f"{call.argument} is a float, so float() and isinstance() accept it.",
    )


def why_look_alike_sent(
    call: DriverCall, refused_ones: Collection[str | None], saw: str, expected: str
) -> Verdict:
    """Why a message went out for what only looks like a number."""
    hint = "Check the type before you convert: is it a number, and not a bool?"

    def fail(cause: str, because: str) -> Verdict:
        return see.failed(cause, saw, expected, because, hint)

    if call.argument == "False" and "True" in refused_ones:
        return fail(
            "refusal.false-sent",
            "Your check rejects True, but False is a bool, too. It was published as an empty battery.",
        )
    if call.sent[0] == 0.0 and call.argument != "False":
        return fail(
            "refusal.look-alike-not-converted",
            "A float32 field needs a Python float. This build sends anything else as 0.0, without an error. The "
            "Ubuntu packages may abort the program instead.",
        )
    if call.argument in BOOLS:
        return fail(
            "refusal.bool-sent",
            "In Python, a bool is a kind of int, so True becomes 1.0: a battery of one percent.",
        )
    return fail(
        "refusal.text-read",
        "float('50') is 50.0, because float() also parses strings. A caller that passes a string has a bug, and "
        "your method hides it.",
    )
