"""Judges what the type checker finds in an answer, and in code that uses it. For exercises of `kind: static`."""

import textwrap
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import ModuleType

from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.vocabulary.mypy_reasons import reason_for
from workbook.criteria.vocabulary.phrasing import count
from workbook.recording.recording import SILENCED, UNCHECKED, UNFINISHED, Finding, Recording

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

    Raises ValueError when it is not valid Python.
    """
    code = textwrap.dedent(code).strip() + "\n"
    try:
        compile(code, name, "exec")
    except SyntaxError as error:
        raise ValueError(f"the probe {name!r} is not valid Python: {error}") from error
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
    if not found:
        return passed("mypy --strict finds nothing")
    expected = "a program in which mypy --strict finds nothing, and which hides nothing from it"
    hidden = _unfinished(recording, expected) or _hidden(found, expected)
    if hidden is not None:
        return hidden
    first = found[0]
    more = f" (and {count(len(found) - 1, 'more finding')})" if len(found) > 1 else ""
    reason = reason_for(first)
    return failed(
        reason.cause,
        f"line {first.line}: {_spelled(first)}{more}",
        expected,
        reason.because,
        reason.try_this,
    )


def _hidden(found: list[Finding], expected: str) -> Verdict | None:
    """A failed verdict when something keeps mypy from checking, or from reporting; else None."""
    for finding in found:
        if finding.code == SILENCED:
            hidden = [one for one in found if one.line == finding.line and one is not finding]
            what = f"hides this: {_spelled(hidden[0])}" if hidden else "silences the type checker"
            return failed(
                "mypy-clean.silenced",
                f"line {finding.line}: `{finding.message}` {what}",
                expected,
                "This doesn't fix anything. It only hides the mistake, and every later mistake in that line. The "
                "judge ignores it.",
                "Remove the comment, run mypy, and fix what it reports.",
            )
        if finding.code == UNCHECKED:
            return failed(
                "mypy-clean.unchecked",
                f"line {finding.line}: {finding.message}",
                expected,
                "mypy does not check this code, so it cannot find mistakes there.",
                "Let mypy check the code that runs. Use if TYPE_CHECKING: only for imports that hints need.",
            )
    return None


def mypy_accepts(recording: Recording, one: Probe) -> Verdict:
    """The type checker finds no error in the unmarked lines of a probe."""
    expected = f"no objection from mypy to {one.name}"
    unfinished = _unfinished(recording, expected)
    if unfinished is not None:
        return unfinished
    right = {number: text for number, text, wrong in one.lines() if not wrong}
    against = [finding for finding in findings(recording, one) if finding.line in right]
    if not against:
        return passed(f"mypy accepts {one.name}")
    first = against[0]
    saw = f"mypy objects to `{right[first.line]}`: {_spelled(first)}"
    if first.code in ("attr-defined", "union-attr"):
        return failed(
            "mypy-accepts.no-such-name",
            saw,
            expected,
            "The code around your node uses this name. It is missing, spelled differently, or may be None.",
            "Keep the names that the exercise gives, and set every attribute in __init__.",
        )
    if first.code in ("arg-type", "call-arg", "call-overload"):
        return failed(
            "mypy-accepts.too-narrow",
            saw,
            expected,
            "Your hints forbid what the exercise allows: they are too narrow, or wrong.",
            "Compare the hint with the exercise's table: what may the caller pass?",
        )
    reason = reason_for(first)
    return failed(reason.cause, saw, expected, reason.because, reason.try_this)


def mypy_objects(recording: Recording, one: Probe, *, cause: str, because: str, try_this: str) -> Verdict:
    """The type checker finds an error in every marked line of a probe, and in no other.

    `cause`, `because` and `try_this`: the feedback when a marked line is accepted.
    """
    accepted = mypy_accepts(recording, one)
    if not accepted.ok:
        return accepted
    found = {finding.line: finding for finding in reversed(findings(recording, one))}
    wrong = {number: text for number, text, marked in one.lines() if marked}
    for number, text in wrong.items():
        if number not in found:
            return failed(
                cause,
                f"mypy accepts `{text}`",
                f"a mypy error for {one.name}",
                because,
                try_this,
            )
    number = next(iter(wrong))
    return passed(f"mypy objects to `{wrong[number]}`: {_spelled(found[number])}")


def _unfinished(recording: Recording, expected: str) -> Verdict | None:
    for finding in findings(recording):
        if finding.code == UNFINISHED:
            return failed(
                "mypy.unfinished",
                finding.message,
                expected,
                "Something in the program makes the type checker run for too long.",
                "Look for types that contain themselves, or for a literal with many thousand elements.",
            )
    return None


def _spelled(finding: Finding) -> str:
    return f"{finding.message} [{finding.code}]"
