"""What mypy says of an answer, explained: why it objects, and what to do. The first reason that fits counts."""

from dataclasses import dataclass

from workbook.recording.recording import Finding


@dataclass(frozen=True)
class Reason:
    """Why mypy objects, by cause id: for findings of this code that have `part` in their message."""

    cause: str
    code: str
    part: str
    because: str
    try_this: str


REASONS = (
    Reason(
        "mypy.untyped-def",
        "no-untyped-def",
        "",
        "mypy does not check a function without hints.",
        "Give every argument a type, and the function a return type: -> None if it returns nothing.",
    ),
    Reason(
        "mypy.explicit-any",
        "explicit-any",
        "",
        "Any accepts everything and allows everything. Where it is used, mypy checks nothing.",
        "Write the type that you mean: float, Float32, Callable[[Float32], None].",
    ),
    Reason(
        "mypy.unimported-any",
        "no-any-unimported",
        "",
        "This type comes from a module without hints, so to mypy it is Any.",
        "Use types that mypy knows: the message packages of the exercise have stubs.",
    ),
    Reason(
        "mypy.generic-publisher",
        "type-arg",
        '"Publisher" expects no type arguments',
        "In this rclpy, Publisher isn't generic. Publisher[String] belongs to a newer rclpy and doesn't run here.",
        "Describe what you need as a Protocol with a type variable, and annotate with that: Sends[Float32].",
    ),
    Reason(
        "mypy.no-type-argument",
        "type-arg",
        "Missing type",
        "A generic type without its argument contains Any: a list of anything, a publisher of anything.",
        "Write what it contains: list[float], Sends[Float32].",
    ),
    Reason(
        "mypy.read-only-name",
        "misc",
        "is read-only",
        "Node already has a property with this name, and it cannot be set.",
        "Give your attribute another name, for example battery_publisher.",
    ),
    Reason(
        "mypy.name-of-supertype",
        "assignment",
        "is incompatible with supertype",
        "The base class already uses this name for something else.",
        "Give your attribute another name.",
    ),
    Reason(
        "mypy.other-type",
        "assignment",
        "",
        "The value does not have the type that was declared for this name.",
        "Either the hint or the value is wrong. Decide which one the robot needs.",
    ),
    Reason(
        "mypy.wrong-argument",
        "arg-type",
        "",
        "The call passes a different type from the one that the function expects.",
        "Compare the two types in the message: the given one and the expected one.",
    ),
    Reason(
        "mypy.no-attribute",
        "attr-defined",
        "",
        "This type has no attribute with that name. Often, this is a spelling mistake.",
        "Look up the names that the class or the message really has.",
    ),
    Reason(
        "mypy.maybe-none",
        "union-attr",
        "",
        "The value may be None here, and None has no such attribute.",
        "Test it first: if ... is not None.",
    ),
    Reason(
        "mypy.other-return",
        "return-value",
        "",
        "The function returns a different type from its hint.",
        "Correct the hint after the arrow, or the returned value.",
    ),
    Reason(
        "mypy.unknown-elements",
        "var-annotated",
        "(hint:",
        "An empty list or dict does not show what it will contain.",
        "Declare it: readings: list[float] = [].",
    ),
    Reason(
        "mypy.unknown-type",
        "var-annotated",
        "",
        "mypy cannot tell the type of this name from the value that it is given.",
        "Write the type as a hint: name: type = value.",
    ),
    Reason(
        "mypy.import-not-found",
        "import-not-found",
        "",
        "There is no module with this name.",
        "Check the spelling. Message classes come from modules such as std_msgs.msg.",
    ),
    Reason(
        "mypy.unused-ignore",
        "unused-ignore",
        "",
        "mypy reports nothing in this line, so the comment has no effect.",
        "Remove the comment.",
    ),
    Reason(
        "mypy.syntax",
        "syntax",
        "",
        "mypy cannot read the file, and neither can Python.",
        "Check the line named above and the line before it: brackets, quotes, colons.",
    ),
)


def reason_for(finding: Finding) -> Reason:
    """The likely reason for a finding of mypy, and one next step."""
    for reason in REASONS:
        if finding.code == reason.code and reason.part in finding.message:
            return reason
    return Reason(
        "mypy.other",
        finding.code,
        "",
        "mypy found a place where your hints do not fit together.",
        "Read the message carefully: it names what was found and what was expected.",
    )
