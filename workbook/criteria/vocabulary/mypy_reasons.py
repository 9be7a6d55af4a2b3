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
        "mypy does not look into a function without hints: whatever stands in there goes unseen.",
        "Give every argument a type, and the function a result: -> None where nothing comes back.",
    ),
    Reason(
        "mypy.explicit-any",
        "explicit-any",
        "",
        "Any accepts everything and allows everything. Where it stands, mypy is blind.",
        "Write the type that is meant: float, Float32, Callable[[Float32], None].",
    ),
    Reason(
        "mypy.unimported-any",
        "no-any-unimported",
        "",
        "This type comes from a module without hints, so to mypy it is Any.",
        "Use types that mypy can see into: the message packages of the exercise have stubs.",
    ),
    Reason(
        "mypy.generic-publisher",
        "type-arg",
        '"Publisher" expects no type arguments',
        "In this rclpy Publisher is not generic. Publisher[String] belongs to a newer one, and it does not run here.",
        "Describe what you need as a Protocol with a type variable, and annotate with that: Sends[Float32].",
    ),
    Reason(
        "mypy.no-type-argument",
        "type-arg",
        "Missing type",
        "A generic type without its argument holds Any: a list of anything, a publisher of anything.",
        "Name what is in it: list[float], Sends[Float32].",
    ),
    Reason(
        "mypy.read-only-name",
        "misc",
        "is read-only",
        "The name is taken: Node has a property of this name, and it cannot be set.",
        "Give your attribute another name, for example battery_publisher.",
    ),
    Reason(
        "mypy.name-of-supertype",
        "assignment",
        "is incompatible with supertype",
        "The name is taken: the base class has something else under it.",
        "Give your attribute another name.",
    ),
    Reason(
        "mypy.other-type",
        "assignment",
        "",
        "The value is not of the type that the name was promised to have.",
        "Either the hint is wrong or the value: decide which one the robot needs.",
    ),
    Reason(
        "mypy.wrong-argument",
        "arg-type",
        "",
        "The call gets something else than the function asks for.",
        "Compare the two types in the message: the one that is given, the one that is expected.",
    ),
    Reason(
        "mypy.no-attribute",
        "attr-defined",
        "",
        "This type has nothing of that name. Often it is a spelling mistake.",
        "Look at what the class or the message really offers.",
    ),
    Reason(
        "mypy.maybe-none",
        "union-attr",
        "",
        "The value may be None here, and None has no such attribute.",
        "Ask first: if it is not None.",
    ),
    Reason(
        "mypy.other-return",
        "return-value",
        "",
        "The function returns something else than its hint says.",
        "Correct the hint after the arrow, or what is returned.",
    ),
    Reason(
        "mypy.unknown-elements",
        "var-annotated",
        "",
        "An empty list or dict does not tell what will be in it.",
        "Say it: readings: list[float] = [].",
    ),
    Reason(
        "mypy.import-not-found",
        "import-not-found",
        "",
        "There is no module of this name.",
        "Check the spelling. Messages come from, for example, std_msgs.msg.",
    ),
    Reason(
        "mypy.unused-ignore",
        "unused-ignore",
        "",
        "There is nothing to ignore in this line.",
        "Remove the comment.",
    ),
    Reason(
        "mypy.syntax",
        "syntax",
        "",
        "mypy cannot read the file, and neither can Python.",
        "Look at the line named above and at the one before it: brackets, quotes, colons.",
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
        "mypy has followed your hints and found a place where they do not fit together.",
        "Read the message slowly: it names what was found and what was expected.",
    )
