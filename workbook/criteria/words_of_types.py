"""Words about what the type checker says of an answer, and of code that uses it. For exercises of `kind: static`."""

import re
import textwrap
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import ModuleType

from workbook.criteria.phrasing import count
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.observing.recording import Finding, Recording
from workbook.observing.typecheck import SILENCED, UNCHECKED, UNFINISHED

MARK = "# wrong"


@dataclass(frozen=True)
class Probe:
    """A piece of code that uses an answer, for the type checker only: it never runs. `name` says what it does."""

    name: str
    code: str

    def lines(self) -> Iterator[tuple[int, str, bool]]:
        """Number and text of each line, and whether it is marked: the checker must object to it."""
        for number, line in enumerate(self.code.splitlines(), start=1):
            text, mark, _ = line.partition(MARK)
            yield number, text.strip(), bool(mark)


def probe(name: str, code: str) -> Probe:
    """Declare code that imports from `answer` and uses it. Lines that end with `# wrong` are misuse.

    Raises ValueError when it is no Python.
    """
    code = textwrap.dedent(code).strip() + "\n"
    try:
        compile(code, name, "exec")
    except SyntaxError as error:
        raise ValueError(f"the probe {name!r} is no Python: {error}") from error
    return Probe(name, code)


def probes_in(module: ModuleType) -> Mapping[str, str]:
    """The probes that a criteria module declares: their code by name. Raises ValueError when two share a name."""
    found = [value for value in vars(module).values() if isinstance(value, Probe)]
    code = {one.name: one.code for one in found}
    if len(code) != len(found):
        raise ValueError("two probes have the same name")
    return code


def findings(recording: Recording, one: Probe | None = None) -> list[Finding]:
    """What the type checker said of the answer, or of a probe.

    Raises ValueError when it was not asked: that needs `kind: static`.
    """
    if recording.findings is None:
        raise ValueError("findings need `kind: static` in the source of the exercise")
    name = "" if one is None else one.name
    return [finding for finding in recording.findings if finding.probe == name]


def mypy_clean(recording: Recording) -> Verdict:
    """The type checker finds nothing in the answer, and the answer hides nothing from it."""
    found = findings(recording)
    expected = "a program in which mypy --strict finds nothing, without anything hidden from it"
    if not found:
        return passed("mypy --strict finds nothing")
    unfinished = _unfinished(recording, expected)
    if unfinished is not None:
        return unfinished
    for finding in found:
        if finding.code == SILENCED:
            hidden = [one for one in found if one.line == finding.line and one is not finding]
            what = f"hides this: {_spelled(hidden[0])}" if hidden else "silences the type checker"
            return failed(
                f"line {finding.line}: `{finding.message}` {what}",
                expected,
                "Such a comment mends nothing. It switches the light off: the mistake stays, and so does the next one "
                "in that line. It is not heeded here.",
                "Remove the comment, run mypy, and mend what it then says.",
            )
        if finding.code == UNCHECKED:
            return failed(
                f"line {finding.line}: {finding.message}",
                expected,
                "mypy does not look at this code, so that it finds nothing there means nothing.",
                "Let mypy see the code that runs. if TYPE_CHECKING: is for imports that only hints need.",
            )
    first = found[0]
    more = f" (and {count(len(found) - 1, 'more finding')})" if len(found) > 1 else ""
    because, try_this = _explained(first)
    return failed(f"line {first.line}: {_spelled(first)}{more}", expected, because, try_this)


def mypy_accepts(recording: Recording, one: Probe) -> Verdict:
    """The type checker has nothing against the unmarked lines of a probe: right use is no error."""
    expected = f"no objection of mypy to {one.name}"
    unfinished = _unfinished(recording, expected)
    if unfinished is not None:
        return unfinished
    right = {number: text for number, text, wrong in one.lines() if not wrong}
    against = [finding for finding in findings(recording, one) if finding.line in right]
    if not against:
        return passed(f"mypy accepts {one.name}")
    first = against[0]
    because, try_this = _explained(first)
    if first.code in ("attr-defined", "union-attr"):
        because = (
            "The code around your node uses this name. It is missing, spelled differently, or may be None."
        )
        try_this = "Keep the names that the exercise gives, and set every attribute in __init__."
    elif first.code in ("arg-type", "call-arg", "call-overload"):
        because = "Your hints forbid what the exercise allows: they are too narrow, or not the ones meant."
        try_this = "Compare the hint with the table of the exercise: what may the caller pass?"
    return failed(f"mypy objects to `{right[first.line]}`: {_spelled(first)}", expected, because, try_this)


def mypy_objects(recording: Recording, one: Probe, *, because: str, try_this: str) -> Verdict:
    """The type checker objects to every marked line of a probe, and to no other.

    `because` and `try_this`: what to say when it has nothing against one of them.
    """
    accepted = mypy_accepts(recording, one)
    if not accepted.ok:
        return accepted
    found = {finding.line: finding for finding in reversed(findings(recording, one))}
    wrong = {number: text for number, text, marked in one.lines() if marked}
    for number, text in wrong.items():
        if number not in found:
            return failed(
                f"mypy has nothing against `{text}`", f"an error of mypy for {one.name}", because, try_this
            )
    number = next(iter(wrong))
    return passed(f"mypy objects to `{wrong[number]}`: {_spelled(found[number])}")


def _unfinished(recording: Recording, expected: str) -> Verdict | None:
    for finding in findings(recording):
        if finding.code == UNFINISHED:
            return failed(
                finding.message,
                expected,
                "Something in the program keeps the type checker busy beyond measure.",
                "Look for types that contain themselves, or for data of many thousand elements in the program text.",
            )
    return None


def _spelled(finding: Finding) -> str:
    return f"{finding.message} [{finding.code}]"


_WHY: tuple[tuple[str, str, str, str], ...] = (
    # code, a part of the message, because, try
    (
        "no-untyped-def",
        "",
        "mypy does not look into a function without hints: whatever stands in there goes unseen.",
        "Give every argument a type, and the function a result: -> None where nothing comes back.",
    ),
    (
        "explicit-any",
        "",
        "Any accepts everything and allows everything. Where it stands, mypy is blind.",
        "Write the type that is meant: float, Float32, Callable[[Float32], None].",
    ),
    (
        "no-any-unimported",
        "",
        "This type comes from a module without hints, so to mypy it is Any.",
        "Use types that mypy can see into: the message packages of the exercise have stubs.",
    ),
    (
        "type-arg",
        '"Publisher" expects no type arguments',
        "In this rclpy Publisher is not generic. Publisher[String] belongs to a newer one, and it does not run here.",
        "Describe what you need as a Protocol with a type variable, and annotate with that: Sends[Float32].",
    ),
    (
        "type-arg",
        "Missing type",
        "A generic type without its argument holds Any: a list of anything, a publisher of anything.",
        "Name what is in it: list[float], Sends[Float32].",
    ),
    (
        "misc",
        "is read-only",
        "The name is taken: Node has a property of this name, and it cannot be set.",
        "Give your attribute another name, for example battery_publisher.",
    ),
    (
        "assignment",
        "is incompatible with supertype",
        "The name is taken: the base class has something else under it.",
        "Give your attribute another name.",
    ),
    (
        "assignment",
        "",
        "The value is not of the type that the name was promised to have.",
        "Either the hint is wrong or the value: decide which one the robot needs.",
    ),
    (
        "arg-type",
        "",
        "The call gets something else than the function asks for.",
        "Compare the two types in the message: the one that is given, the one that is expected.",
    ),
    (
        "attr-defined",
        "",
        "This type has nothing of that name. Often it is a spelling mistake.",
        "Look at what the class or the message really offers.",
    ),
    (
        "union-attr",
        "",
        "The value may be None here, and None has no such attribute.",
        "Ask first: if it is not None.",
    ),
    (
        "return-value",
        "",
        "The function returns something else than its hint says.",
        "Correct the hint after the arrow, or what is returned.",
    ),
    (
        "var-annotated",
        "",
        "An empty list or dict does not tell what will be in it.",
        "Say it: readings: list[float] = [].",
    ),
    (
        "import-not-found",
        "",
        "There is no module of this name.",
        "Check the spelling. Messages come from, for example, std_msgs.msg.",
    ),
    (
        "unused-ignore",
        "",
        "There is nothing to ignore in this line.",
        "Remove the comment.",
    ),
    (
        "syntax",
        "",
        "mypy cannot read the file, and neither can Python.",
        "Look at the line named above and at the one before it: brackets, quotes, colons.",
    ),
)


def _explained(finding: Finding) -> tuple[str, str]:
    """The likely reason for a finding of mypy, and one next step."""
    for code, part, because, try_this in _WHY:
        if finding.code == code and re.search(re.escape(part), finding.message):
            return because, try_this
    return (
        "mypy has followed your hints and found a place where they do not fit together.",
        "Read the message slowly: it names what was found and what was expected.",
    )
