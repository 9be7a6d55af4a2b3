"""Judge exercise 03 by the calls of publish_level, and by the messages on /robot/battery that each call causes."""

import math
import re
from collections.abc import Collection, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import pairwise
from random import Random

from std_msgs.msg import Float32, String

import workbook.criteria as see
from workbook.criteria import DriverCall, Recording, Verdict, criterion, program_runs, topic, watching

WORDS = see.Words(__file__)
BATTERY = topic("/robot/battery", Float32)
REPORT = topic("/driver/report", String, signed=True)
TOLERANCE = 1e-5  # the rounding error of a 32-bit charge; the task states it

COUNT = 40  # calls
BOOLS = ("True", "False")
NO_WORDS = ("full", "empty", "none", "ok")

# the kinds of arguments, as regular expressions of their Python literals
FLOAT, EMPTY, OTHER_NUMBER = NUMBERS = ("a float", "an empty battery", "an int or a NumPy number")
NOT_FINITE, LOOK_ALIKE, NO_NUMBER = REFUSED = ("not finite", "looks like a number", "no number")
KINDS = {
    EMPTY: r"0\.0",
    FLOAT: r"\d+\.\d+",
    OTHER_NUMBER: r"(np\.\w+\()?\d+(\.\d+)?\)?",
    NOT_FINITE: r"(np\.\w+\()?-?(nan|inf)\)?",
    LOOK_ALIKE: r"True|False|' *\d+(\.\d+)? *'",
    NO_NUMBER: r"(?s).+",
}


def kind_of(argument: str | None) -> str:
    """Return the kind of an argument, or "" if there is no argument."""
    return next((kind for kind, form in KINDS.items() if re.fullmatch(form, argument or "")), "")


def number_in(argument: str | None) -> float | None:
    """Return the number that must arrive for an argument, or None if the answer must refuse the argument."""
    is_number = kind_of(argument) in NUMBERS
    return float(re.sub(r"np\.\w+\(|\)", "", argument or "")) if is_number else None


def odd(rng: Random, low: int, high: int) -> int:
    """Draw a two-digit number that doesn't end in 0, unlike the whole numbers in string arguments."""
    return 10 * rng.randint(low, high) + rng.randint(1, 9)


def drawn_arguments(rng: Random) -> list[str]:
    """Draw the arguments of all calls: six numbers, then the rest in random order, with a few fixed sequences."""
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
    # A bool, an empty battery twice, and a string: if a zero affects later calls, a call to refuse comes right after
    # the zero.
    units = [[bools[0], "0.0", "0.0", texts[0]], [f"np.int64({small})", small], *([one] for one in single)]
    rng.shuffle(units)
    # Values that aren't finite come after numbers, because a method that stores wrong types may or may not store such
    # values.
    not_finite = ["np.float32(nan)", "np.float64(-inf)", "np.float32(-inf)", "nan", "inf"]
    rng.shuffle(not_finite)
    first_minus = min(not_finite.index(f"np.{kind}(-inf)") for kind in ("float32", "float64"))
    not_finite.insert(rng.randint(0, first_minus), "-inf")
    places = rng.sample([n for n, unit in enumerate(units) if kind_of(unit[-1]) in NUMBERS], len(not_finite))
    for place, argument in zip(sorted(places), not_finite, strict=True):
        units[place].append(argument)
    return [*begin, *(argument for unit in units for argument in unit)]


def fits(arguments: Sequence[str]) -> bool:
    """Return whether each mistake is recognizable in this sequence of calls.

    A method that publishes the last number again, instead of raising an error, must not look like another mistake. If a
    refused call affects later calls, the effect must show in a float and in a number of another type.
    """
    kinds, sent = [*map(kind_of, arguments)], 0.0
    for n, (argument, kind) in enumerate(zip(arguments, kinds, strict=True)):
        if (
            (kind == NOT_FINITE and sent == 100.0)
            or (argument == "True" and sent == 1.0)
            or (kind == EMPTY and sent < 1.0 and kinds[n - 1] != EMPTY)
            or (argument.startswith("0.0000") and sent == 0.0)
            or (kind == NO_NUMBER and sent == 0.0 and NO_NUMBER not in kinds[:n])
        ):
            return False
        number = number_in(argument)
        sent = sent if number is None else number
    after = {kind for before, kind in pairwise(kinds) if before in (NO_NUMBER, LOOK_ALIKE)}
    return (
        arguments[kinds.index(LOOK_ALIKE)] in BOOLS
        and after >= {FLOAT, OTHER_NUMBER}
        and [kind for kind in kinds if kind in NUMBERS][-1] == FLOAT
        and sent > 1.0
    )


def drawn(rng: Random) -> list[see.Part]:
    """Draw the script: valid and invalid arguments, some repeated right away, and some repeated much later."""
    arguments = drawn_arguments(rng)
    while not fits(arguments):
        arguments = drawn_arguments(rng)
    return [see.publish("/driver/calls", String, [(0.0, "\n".join(arguments))], "latched")]


AT_ONCE = 4  # the driver makes this call right after the previous one; usually, it pauses for 0.06 s
NEVER_AWAITED = "publish_level' was never awaited"  # Python's warning in the log
MISTAKES = ("NameError", "AttributeError", "UnboundLocalError")

WATCH = watching(wall_seconds=5.0, script=drawn)


def as_float(value: float) -> str:
    """Format a number as Python formats a float: 64.0, 99.9, nan."""
    return f"{value:.1f}" if value.is_integer() else f"{value:.7g}"


class Call(DriverCall):
    """One of the driver's calls, as reported by the driver."""

    due: Collection[float] = ()  # the numbers that must arrive for all calls

    def __init__(self, reported: DriverCall) -> None:
        super().__init__(**vars(reported))
        self.kind = kind_of(self.argument)
        self.is_number = self.kind in NUMBERS
        self.meant = number_in(self.argument) or 0.0  # the number that the call must publish
        # The criterion for bools judges a published False, and the one for floats judges a rounded 0.1.
        may_be_zero = self.argument == "False" or (self.is_number and self.meant < 1.0)
        self.is_other_than_zero = self.complete and not may_be_zero

    @property
    def arrived(self) -> bool:
        """Whether the call published its number exactly once, and returned."""
        sent_once = self.how == "returned" and not self.later and len(self.sent) == 1
        return sent_once and abs(float(self.sent[0]) - self.meant) <= TOLERANCE

    @property
    def strange(self) -> list[float]:
        """The values published after the call that equal none of the numbers to publish.

        Repeated numbers are left out, because they already cost the points for numbers.
        """
        return [one for one in self.later if all(abs(one - number) > TOLERANCE for number in self.due)]

    @property
    def refused(self) -> bool:
        """Whether the call raised an error and didn't publish a value."""
        return self.how == "raised" and not self.sent and not self.strange

    def sends_number_of(self, before: "Call") -> bool:
        """Return whether this call published the number of the call `before` instead of its own."""
        return self.meant != before.meant and any(abs(n - before.meant) <= TOLERANCE for n in self.sent[:1])


class Calls:
    """The calls that the driver reported, and the values published during and between them."""

    def __init__(self, recording: Recording) -> None:
        self.recording = recording
        self.reports = see.driver_reports(recording, REPORT)
        self.trouble = self.reported("not made: ")  # why the driver couldn't make any call, if it couldn't
        # the first element stands for the time before any call
        self.all = [Call(one) for one in see.driver_calls(recording, REPORT, BATTERY)]
        self.judged = [call for call in self.all if call.number and call.complete]
        self.numbers = [call for call in self.judged if call.is_number]
        for call in self.judged:
            call.due = {one.meant for one in self.numbers}
        words = see.published(recording, "/driver/calls")
        self.requested = [line for word in words for line in word.value["data"].splitlines()]
        self.made = {one.number: one.argument for one in self.all if one.argument is not None and one.number}
        self.not_requested = [text for n, text in self.made.items() if self.requested[n - 1 : n] != [text]]
        self.too_few = "done" in self.reports and 0 < max(self.made, default=0) < len(self.requested)
        # the argument of the last call that began, or [] if no call began or its report was lost
        self.latest = [one.argument for one in self.all[-1:] if one.number and one.argument is not None]

    def reported(self, begin: str) -> list[str]:
        """Return the rest of each report that begins with `begin`."""
        return [report.removeprefix(begin) for report in self.reports if report.startswith(begin)]

    @property
    def at_the_start(self) -> list[float]:
        """The values published when the node was created. Only the driver, in the same process, could observe them."""
        return [float(level) for level in self.reported("sent before any call: ")]

    @property
    def early(self) -> list[str]:
        """The values published before any call."""
        return [as_float(level) for level in (*self.at_the_start, *self.all[0].later)]

    @cached_property
    def invented(self) -> list[str]:
        """The arguments for which the node published a zero, although none of them is a zero."""
        may_be_zero = [call.number for call in self.all if call.number and not call.is_other_than_zero]
        first = min(may_be_zero, default=0)
        invented = [
            call.argument or "nothing at all"
            for call in self.all
            if (0.0 in call.sent and call.is_other_than_zero) or (0.0 in call.later and call.number < first)
        ]
        return list(dict.fromkeys([*["nothing at all"] * (0.0 in self.at_the_start), *invented]))


calls = see.once(Calls)


class Case:
    """A call that went wrong, along with all judged calls."""

    def __init__(self, call: Call, judged: Sequence[Call]) -> None:
        self.call, self.kind, self.tolerance = call, call.kind, TOLERANCE
        self.argument = text = call.argument or ""
        types = {"'": "a string", "[": "a list", "(": "a tuple"}
        name = "a bool" if text in BOOLS else "an int" if text.isdecimal() else types.get(text[:1])
        self.type = f", {name}," if name else ""  # between commas, if the type isn't obvious
        self.raised, self.wanted = call.how == "raised", as_float(call.meant)
        self.published = [as_float(one) for one in call.sent] or ["nothing"]
        self.followed = [as_float(one) for one in call.later[:1]]  # after the call had returned
        self.first_strange = [as_float(one) for one in call.strange[:1]]
        self.sent = float(call.sent[0]) if call.sent else math.nan
        self.numbers = [one for one in judged if one.is_number]
        self.before = [one for one in self.numbers if one.number < call.number]
        self.after = [one for one in self.numbers if one.number > call.number]
        self.arrived = [one for one in self.numbers if one.arrived]
        self.last_sent = [0.0, *(float(one.sent[-1]) for one in self.before if one.sent)][-1]
        self.returned_for = {one.argument for one in judged if one.how == "returned"}
        self.zero_raised = any(one.how == "raised" for one in judged if one.argument == "0.0")
        self.refused_for = {one.argument for one in judged if one.refused}

        # whether the same number arrived before, or all numbers arrived until some call after a refusal, and no number
        # since then
        same_arrived = any(one.argument == call.argument and one.arrived for one in self.before)
        first_refused = min((one.number for one in judged if one.refused and not one.is_number), default=0)
        first_lost = next((one.number for one in self.numbers if not one.arrived), 0)
        only_until = all(one.arrived == (one.number < first_lost) for one in self.numbers)
        self.worked_before = same_arrived or (1 < first_refused < first_lost and only_until)

        # whether the missing numbers are those that follow a refused call, or a refused call of one kind
        pairs = [(last, one) for last, one in pairwise(judged) if one.is_number]
        lost = {one.number for _, one in pairs if not one.arrived}
        errors = [(last.kind, one.number) for last, one in pairs if last.how == "raised"]
        kinds = [{NO_NUMBER}, {LOOK_ALIKE}, {NO_NUMBER, LOOK_ALIKE}, {NOT_FINITE}, {"", *REFUSED}]
        groups = [{number for kind, number in errors if kind in some} for some in kinds]
        self.only_after_errors = any(lost <= after and len(after) - 1 <= len(lost) > 2 for after in groups)

        same_before = any(one.arrived and one.meant == call.meant for one in self.before)
        self.is_repeat = same_before and any(one.arrived for one in self.after)
        floats = [one for one in judged if one.kind == FLOAT]
        self.only_small_raised = all((one.how == "raised") == (one.meant < 1.0) for one in floats)
        rounded = [round(call.meant, digits) for digits in range(5)]
        is_near = any(abs(one - self.sent) <= TOLERANCE for one in rounded)
        self.is_rounded = is_near or call.meant // 1 == self.sent
        same = [one for one in judged if one.argument == call.argument]
        self.differs = any(one.sent and abs(one.sent[0] - self.sent) > TOLERANCE for one in same)


NOT_MADE = WORDS.rules(
    Calls,
    "calls-come-back",
    ("needs-arguments", lambda f: "BatteryPublisher.__init__() missing" in f.trouble[0]),
    ("by-error", lambda f: "raised" in f.trouble[0], see.failed_in_call),
    ("name-missing", see.otherwise),
    when=lambda f: f.trouble,
)
NOT_REQUESTED = WORDS.seen("calls-come-back.not-requested", Calls)
TOO_FEW = WORDS.seen("calls-come-back.too-few", Calls)
OTHER_ORDERS = WORDS.cause("calls-come-back.other-orders", ("saw",))
STOPPED = WORDS.rules(
    Calls,
    "calls-come-back",
    ("program-ended", lambda f: f.recording.process.ended_by == "itself"),
    ("method-waits", lambda f: f.latest),
    ("import-does-not-end", see.otherwise),
    when=lambda f: "done" not in f.reports,
)
COROUTINE = WORDS.cause("number.coroutine", Case)
RAISED = WORDS.rules(
    Case,
    "number",
    ("no-message-made", lambda f: f.call.error.startswith("TypeError: Expected <class")),
    ("mistake", lambda f: f.call.error.startswith(MISTAKES)),
    ("refused-later", lambda f: f.worked_before or f.only_after_errors),
    ("taken-for-bool", lambda f: f.call.meant in (0.0, 1.0) and f.returned_for.isdisjoint({"0.0", "1.0"})),
    ("zero-taken-for-missing", lambda f: f.call.meant in (0.0, 1.0) and f.zero_raised),
    ("int-refused", lambda f: f.call.meant in (0.0, 1.0)),
    ("refused", lambda f: f.kind == OTHER_NUMBER),
    ("small-refused", lambda f: f.only_small_raised),
    ("raised", see.otherwise),
)
NOTHING_SENT = WORDS.rules(
    Case,
    "number",
    ("dropped-soon-after", lambda f: f.call.number == AT_ONCE and any(one.arrived for one in f.after[:1])),
    ("sent-later", lambda f: any(one.later for one in f.numbers)),
    ("one-behind", lambda f: any(one.sends_number_of(f.call) for one in f.after[:1])),
    ("dropped-after-error", lambda f: f.only_after_errors),
    ("repeat-dropped", lambda f: f.is_repeat),
    ("zero-dropped", lambda f: f.call.meant == 0.0),
    ("stops", lambda f: f.arrived and f.after and not any(one.sent for one in f.after)),
    ("not-sent", see.otherwise),
)
SENT = WORDS.rules(
    Case,
    "number",
    ("sent-again", lambda f: len(f.call.sent) > 1 or f.call.later),
    ("not-converted", lambda f: f.kind == OTHER_NUMBER and f.sent == 0.0),
    ("fraction", lambda f: f.sent and abs(100.0 * f.sent - f.call.meant) <= 100.0 * TOLERANCE),
    ("one-behind", lambda f: any(f.call.sends_number_of(one) for one in f.before[-1:])),
    ("rounded", lambda f: f.is_rounded),
    ("depends-on-earlier", lambda f: f.differs),
    ("changed", see.otherwise),
)
NOT_REFUSED = WORDS.rules(
    Case,
    "refusal",
    ("last-again", lambda f: f.call.sent and 0.0 != f.last_sent == f.call.sent[0]),
    ("too-late", lambda f: f.raised and f.call.sent),
    ("sent-later", lambda f: not f.call.sent and f.call.strange),
    ("silent", lambda f: not f.call.sent),
    ("nan-limited", lambda f: f.kind == NOT_FINITE and 0.0 <= f.sent <= 100.0),
    ("negative-infinity", lambda f: f.argument == "-inf" and "inf" in f.refused_for),
    ("numpy-not-finite", lambda f: f.kind == NOT_FINITE and {"nan", "inf", "-inf"} <= f.refused_for),
    ("not-finite-sent", lambda f: f.kind == NOT_FINITE),
    ("false-sent", lambda f: f.argument == "False" and "True" in f.refused_for),
    ("look-alike-not-converted", lambda f: f.kind == LOOK_ALIKE and f.argument != "False" and f.sent == 0.0),
    ("bool-sent", lambda f: f.argument in BOOLS),
    ("text-read", lambda f: f.kind == LOOK_ALIKE),
    ("no-number-sent", see.otherwise),
)
UNCALLED = WORDS.cause("floats-arrive.uncalled", Calls)
INVENTED_ZERO = WORDS.rules(Calls, "no-invented-zero", ("sent", lambda f: f.invented))


@criterion(points=0, title="BatteryPublisher() can be created, and every call ends", needs=[program_runs])
def calls_come_back(recording: Recording) -> Verdict:
    facts = calls(recording)
    if not facts.trouble and facts.requested and (facts.not_requested or facts.too_few):
        saw, _ = NOT_REQUESTED(facts) if facts.not_requested else TOO_FEW(facts)
        return OTHER_ORDERS.verdict(saw=saw)
    return NOT_MADE.first(facts) or STOPPED.first(facts) or see.passed(f"{COUNT} calls made")


@criterion(points=1, title="/robot/battery carries Float32", needs=[calls_come_back])
def battery_topic(recording: Recording) -> Verdict:
    # The log contains the calls' errors. These errors are judged one by one and don't explain a missing topic.
    silent = replace(recording, process=replace(recording.process, log=""))
    return see.publishes(silent, BATTERY)


@criterion(points=0, title="publish_level publishes numbers", needs=[battery_topic])
def sends(recording: Recording) -> Verdict:
    numbers = calls(recording).numbers
    if any(call.sent or call.later for call in numbers):
        return see.passed("numbers are published")
    case = Case(numbers[0], numbers)
    return COROUTINE.verdict(case) if NEVER_AWAITED in recording.process.log else blamed(case)


@criterion(points=2, title="Each float arrives unchanged, exactly once", needs=[sends])
def floats_arrive(recording: Recording) -> Verdict:
    verdict = all_right(recording, FLOAT, f"all floats arrived within {see.number(TOLERANCE)}")
    facts = calls(recording)
    return UNCALLED.verdict(facts) if verdict.ok and facts.early else verdict


@criterion(points=1, title="A measured 0.0 arrives", needs=[sends])
def zero_arrives(recording: Recording) -> Verdict:
    return all_right(recording, EMPTY, "0.0 arrived as 0.0")


@criterion(points=2, title="Each int and NumPy number arrives unchanged, exactly once", needs=[sends])
def numbers_arrive(recording: Recording) -> Verdict:
    return all_right(recording, OTHER_NUMBER, "ints and NumPy numbers arrived with the right values")


@criterion(points=1, title="None, words, lists, and tuples are rejected with an error", needs=[sends])
def no_number_refused(recording: Recording) -> Verdict:
    return all_right(recording, NO_NUMBER, "None, words, lists, and a tuple raised an error")


@criterion(points=1, title="Bools and strings such as '50' are rejected with an error", needs=[sends])
def look_alikes_refused(recording: Recording) -> Verdict:
    return all_right(recording, LOOK_ALIKE, "bools and strings of digits raised an error")


@criterion(points=1, title="nan, inf, and -inf are rejected with an error", needs=[sends])
def not_finite_refused(recording: Recording) -> Verdict:
    return all_right(recording, NOT_FINITE, "nan, inf, and -inf raised an error")


@criterion(points=1, title="No 0.0 is published by mistake", needs=[sends])
def no_invented_zero(recording: Recording) -> Verdict:
    well = see.passed("0.0 was published only for an empty battery")
    return INVENTED_ZERO.first(calls(recording)) or well


def all_right(recording: Recording, kind: str, praise: str) -> Verdict:
    """Check all calls with this kind of argument: numbers must have arrived, and other arguments must be refused."""
    judged = calls(recording).judged
    made = [call for call in judged if call.kind == kind]
    wrong = [call for call in made if not (call.arrived if call.is_number else call.refused)]
    return blamed(Case(wrong[0], judged)) if wrong else see.passed(praise)


def blamed(case: Case) -> Verdict:
    not_arrived = RAISED if case.raised else SENT if case.call.sent else NOTHING_SENT
    return (not_arrived if case.call.is_number else NOT_REFUSED).verdict(case)
