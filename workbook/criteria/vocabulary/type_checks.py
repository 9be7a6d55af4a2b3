"""Judge the type checker's findings in an answer, and in code that uses it, for exercises with `kind: static`."""

import textwrap
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import ModuleType

from workbook.criteria.rules import Reason, Words
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.vocabulary.mypy_reasons import reason_for
from workbook.criteria.vocabulary.phrasing import count
from workbook.recording.recording import SILENCED, UNCHECKED, UNFINISHED, Finding, Recording

WORDS = Words(__file__)

MARK = "# wrong"
_FOUND = WORDS.seen("mypy-clean.finding", ("finding", "more"))
_SILENCED = WORDS.cause("mypy-clean.silenced", ("finding", "hides"))
_UNCHECKED = WORDS.cause("mypy-clean.unchecked", ("finding",))
_UNFINISHED = WORDS.cause("mypy.unfinished", ("finding", "expected"))
_ACCEPTED = WORDS.seen("mypy-objects.accepted", ("text", "name"))


@dataclass(frozen=True)
class _Objection:
    """A mypy finding in a correct line of a probe. `text`: the line. `name`: the probe's name."""

    finding: Finding
    text: str
    name: str


_OBJECTED = WORDS.seen("mypy-accepts.finding", _Objection)
_OBJECTIONS = WORDS.rules(
    _Objection,
    "mypy-accepts",
    ("no-such-name", lambda one: one.finding.code in ("attr-defined", "union-attr")),
    ("too-narrow", lambda one: one.finding.code in ("arg-type", "call-arg", "call-overload")),
)


@dataclass(frozen=True)
class Probe:
    """Code that uses an answer, for the type checker only: it never runs. `name`: a description of the code."""

    name: str
    code: str

    def lines(self) -> Iterator[tuple[int, str, bool]]:
        """Yield each line's number, source, and whether it's marked. The type checker must object to marked lines."""
        for number, line in enumerate(self.code.splitlines(), start=1):
            text, mark, _ = line.partition(MARK)
            yield number, text.strip(), bool(mark)


def probe(name: str, code: str) -> Probe:
    """Declare code that imports names from `answer` and uses them. A line that ends with `# wrong` misuses them.

    Raises ValueError if the code isn't valid Python.
    """
    code = textwrap.dedent(code).strip() + "\n"
    try:
        compile(code, name, "exec")
    except SyntaxError as error:
        raise ValueError(f"the probe {name!r} is not valid Python: {error}") from error
    return Probe(name, code)


def probes_in(module: ModuleType) -> Mapping[str, str]:
    """Return the probes that a criteria module declares, as a mapping from name to code.

    Raises ValueError if two probes share a name.
    """
    found = [value for value in vars(module).values() if isinstance(value, Probe)]
    code = {one.name: one.code for one in found}
    if len(code) != len(found):
        raise ValueError("two probes have the same name")
    return code


def findings(recording: Recording, one: Probe | None = None) -> list[Finding]:
    """Return the type checker's findings in the answer, or in the probe `one`.

    Raises ValueError if the checker didn't run, because the exercise isn't of `kind: static`.
    """
    if recording.findings is None:
        raise ValueError("findings need `kind: static` in the source of the exercise")
    name = "" if one is None else one.name
    return [finding for finding in recording.findings if finding.probe == name]


def mypy_clean(recording: Recording) -> Verdict:
    """Check that the type checker has no findings in the answer, and that the answer doesn't hide code from it."""
    found = findings(recording)
    if not found:
        return passed("mypy --strict finds nothing")
    more = f" (and {count(len(found) - 1, 'more finding')})" if len(found) > 1 else ""
    saw, expected = _FOUND(finding=found[0], more=more)
    reason = reason_for(found[0])
    return _unfinished(recording, expected) or _hidden(found) or failed(reason.id, saw, expected, *reason())


def _hidden(found: list[Finding]) -> Verdict | None:
    """Return a failed verdict if the answer keeps mypy from checking or reporting, or None otherwise."""
    for finding in found:
        if finding.code == SILENCED:
            hidden = [one for one in found if one.line == finding.line and one is not finding]
            hides = f"hides this: {_spelled(hidden[0])}" if hidden else "silences the type checker"
            return _SILENCED.verdict(finding=finding, hides=hides)
        if finding.code == UNCHECKED:
            return _UNCHECKED.verdict(finding=finding)
    return None


def mypy_accepts(recording: Recording, one: Probe) -> Verdict:
    """Check that the type checker doesn't find an error in the unmarked lines of a probe."""
    expected = f"no objection from mypy to {one.name}"
    unfinished = _unfinished(recording, expected)
    if unfinished is not None:
        return unfinished
    right = {number: text for number, text, wrong in one.lines() if not wrong}
    against = [finding for finding in findings(recording, one) if finding.line in right]
    if not against:
        return passed(f"mypy accepts {one.name}")
    first = against[0]
    objection = _Objection(first, right[first.line], one.name)
    reason = reason_for(first)
    return _OBJECTIONS.first(objection) or failed(reason.id, *_OBJECTED(objection), *reason())


def mypy_objects(recording: Recording, one: Probe, why_not: Reason) -> Verdict:
    """Check that the type checker finds an error in every marked line of a probe, and in no other line.

    `why_not`: the reason to give the student if the checker accepts a marked line. Declare it with `WORDS.reason(...)`.
    """
    accepted = mypy_accepts(recording, one)
    if not accepted.ok:
        return accepted
    found = {finding.line: finding for finding in reversed(findings(recording, one))}
    wrong = {number: text for number, text, marked in one.lines() if marked}
    for number, text in wrong.items():
        if number not in found:
            return failed(why_not.id, *_ACCEPTED(text=text, name=one.name), *why_not())
    number = next(iter(wrong))
    return passed(f"mypy objects to `{wrong[number]}`: {_spelled(found[number])}")


def _unfinished(recording: Recording, expected: str) -> Verdict | None:
    unfinished = (one for one in findings(recording) if one.code == UNFINISHED)
    return next((_UNFINISHED.verdict(finding=one, expected=expected) for one in unfinished), None)


def _spelled(finding: Finding) -> str:
    return f"{finding.message} [{finding.code}]"
