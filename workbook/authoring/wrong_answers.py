"""Read wrong answers, ``tests/wrong_answers/NN_slug/NAME.py``: programs with one mistake each that must lose points.

Most mistakes are only a few lines, so the file contains those lines, and the rest comes from a right answer::

    # The period is half of what it should be.
    # loses: joint_rate
    # says: 1 Hz
    # replaces: self.create_timer(2.0, self.publish_joints)
    self.create_timer(1.0, self.publish_joints)

The header is the comment at the beginning of the file. Its sentences describe the mistake. Its fields are

    loses      criteria that fail or earn only part of their points, separated by commas
    also       criteria that may be lost as well, depending on how busy the machine is
    skips      all criteria that are skipped; if the field is missing, skipped criteria aren't compared
    cause      cause ID of the first lost criterion's verdict; several are allowed if milliseconds decide
    says       words that the first lost criterion's feedback must contain; may be repeated
    soak       `yes` if the mistake shows only when the program runs in real time
    compiles   `no` if Python can't compile the program
    on         the program that is changed: `solution` (the default), `starter`, or `right/NAME.py`

Each change names lines of that program, one comment per line. The code below the comments replaces the `# replaces:`
lines; without code, those lines are deleted. `# after:` and `# before:` lines stay, and the code is inserted after or
before them. The named lines must occur exactly once in the program, at any indentation. The code is indented to fit
them, so only its relative indentation counts. A file without changes is a whole program.
"""

import re
import textwrap
import warnings
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path

from workbook.authoring.tree import AuthoringError, Tree
from workbook.exercise import source
from workbook.exercise.answers import Answer, read_answer

FIELDS = ("loses", "also", "skips", "cause", "says", "soak", "compiles", "on")
SOLUTION, STARTER = "solution", "starter"
_FIELD = re.compile(r"#\s*(?P<name>[a-z]+):\s*(?P<value>.*)")
_CHANGE = re.compile(r"# (?P<verb>replaces|after|before):(?: (?P<text>.*))?")


class WrongAnswerError(AuthoringError):
    """Raised when a wrong answer can't be read. The message begins with ``file:line``."""

    def __init__(self, path: Path, line: int, problem: str) -> None:
        super().__init__(f"{path}:{line}: {problem}")


@dataclass(frozen=True)
class Header:
    """A wrong answer's header: a description of the mistake, and the criteria that it must lose."""

    about: str
    """A description of the mistake, or an empty string if the program's docstring describes it."""
    loses: frozenset[str]
    also: frozenset[str]
    """Criteria that may be lost as well, depending on how busy the machine is."""
    skips: frozenset[str] | None
    causes: frozenset[str]
    """The first lost criterion must have one of these cause IDs. There are several if milliseconds decide."""
    says: tuple[str, ...]
    soak: bool
    compiles: bool
    on: str | None
    """The program that is changed, or None if the field is missing."""


@dataclass(frozen=True)
class Change:
    """Some lines of a program, and the lines that replace them. Only their relative indentation counts."""

    line: int
    """The line of the wrong answer's file in which the change begins."""
    old: tuple[str, ...]
    new: tuple[str, ...]
    """The replacement, including the old lines if they stay."""


@dataclass(frozen=True)
class WrongAnswer:
    """A wrong answer: its header, its changes, and the resulting program."""

    path: Path
    header: Header
    changes: tuple[Change, ...]
    """Empty for a whole program."""
    answer: Answer


def read_wrong_answer(tree: Tree, path: Path) -> WrongAnswer:
    """Read one wrong answer; its folder names the exercise.

    Raises:
        WrongAnswerError: the header is invalid, a change doesn't apply exactly once, the program is unchanged, or
            the header's `compiles` field is wrong.
        OSError: a file can't be read.
    """
    lines = path.read_text(encoding="utf-8").splitlines()
    header, rest = _header(path, lines)
    changes = tuple(_changes(path, lines, rest))
    base = _program(tree, path, header.on or SOLUTION)
    if changes:
        answer = Answer(_changed(path, base, changes))
    elif header.on is not None:
        raise WrongAnswerError(path, 1, "names a program with '# on:' and changes nothing in it")
    else:
        answer = read_answer(path, path.parent.name)
    if answer.text == base:
        raise WrongAnswerError(path, 1, f"is the program that it changes ({header.on or SOLUTION})")
    problem = _compile_problem(answer.text)
    if header.compiles and problem:
        raise WrongAnswerError(
            path, 1, f"does not compile: {problem}. If this is the mistake, write '# compiles: no'"
        )
    if not header.compiles and not problem:
        raise WrongAnswerError(path, 1, "says '# compiles: no', but it does compile")
    return WrongAnswer(path, header, changes, answer)


def read_header(path: Path) -> Header:
    """Read only a wrong answer's header.

    Raises:
        WrongAnswerError: a field is missing, unknown, or malformed.
        OSError: the file can't be read.
    """
    return _header(path, path.read_text(encoding="utf-8").splitlines())[0]


def _header(path: Path, lines: Sequence[str]) -> tuple[Header, int]:
    """Return the header, and the index of the first line after it."""
    about: list[str] = []
    fields: dict[str, list[str]] = {}
    end = 0
    for end, line in enumerate([*lines, ""]):
        if not line.startswith("#") or _CHANGE.fullmatch(line.rstrip()):
            break
        found = _FIELD.fullmatch(line.rstrip())
        if found is None:
            about.append(line.lstrip("#").strip())
            continue
        name, value = found["name"], found["value"]
        if name not in FIELDS:
            near = get_close_matches(name, FIELDS, n=1)
            guess = f" Did you mean {near[0]}?" if near else ""
            raise WrongAnswerError(
                path, end + 1, f"unknown field {name!r}.{guess} There are: {', '.join(FIELDS)}"
            )
        if not value:
            raise WrongAnswerError(path, end + 1, f"'# {name}:' is empty")
        if name in fields and name not in ("loses", "also", "skips", "says"):
            raise WrongAnswerError(path, end + 1, f"'# {name}:' stands here a second time")
        fields.setdefault(name, []).append(value)
    if "loses" not in fields:
        raise WrongAnswerError(path, 1, "must begin with '# loses: ' and the criteria that it loses")
    if "says" not in fields and "cause" not in fields:
        raise WrongAnswerError(
            path, 1, "needs '# cause: ' and an id, or '# says: ' and words of the feedback"
        )
    header = Header(
        about=" ".join(about),
        loses=_names(fields["loses"]),
        also=_names(fields.get("also", ())),
        skips=_names(fields["skips"]) if "skips" in fields else None,
        causes=_names(fields.get("cause", ())),
        says=tuple(fields.get("says", ())),
        soak=_only(path, fields, "soak", "yes"),
        compiles=not _only(path, fields, "compiles", "no"),
        on=fields["on"][0] if "on" in fields else None,
    )
    return header, end


def _names(texts: Sequence[str]) -> frozenset[str]:
    return frozenset(name.strip() for text in texts for name in text.split(",") if name.strip())


def _only(path: Path, fields: dict[str, list[str]], name: str, value: str) -> bool:
    """Return whether an optional field exists. Raises WrongAnswerError if its value isn't `value`."""
    if name in fields and fields[name] != [value]:
        raise WrongAnswerError(path, 1, f"'# {name}:' must be '{value}', not {fields[name][0]!r}")
    return name in fields


def _changes(path: Path, lines: Sequence[str], start: int) -> Iterator[Change]:
    at = start
    while at < len(lines) and not lines[at].strip():
        at += 1
    if at == len(lines) or not _CHANGE.fullmatch(lines[at].rstrip()):
        return
    while at < len(lines):
        first, verbs, old = at, set[str](), list[str]()
        while at < len(lines) and (found := _CHANGE.fullmatch(lines[at].rstrip())):
            verbs.add(found["verb"])
            old.append((found["text"] or "").rstrip())
            at += 1
        if len(verbs) > 1:
            raise WrongAnswerError(path, first + 1, f"mixes {' and '.join(sorted(verbs))} in one change")
        below = at
        while at < len(lines) and not _CHANGE.fullmatch(lines[at].rstrip()):
            at += 1
        new = _trimmed(lines[below:at])
        if not any(line.strip() for line in old):
            raise WrongAnswerError(path, first + 1, "names no line")
        verb = verbs.pop()
        if verb != "replaces" and not new:
            raise WrongAnswerError(path, first + 1, f"puts nothing {verb} this line")
        above, below_it = old if verb == "after" else (), old if verb == "before" else ()
        yield Change(first + 1, tuple(old), (*above, *new, *below_it))


def _trimmed(lines: Sequence[str]) -> tuple[str, ...]:
    """Return the lines without blank lines at the beginning and the end."""
    full = [index for index, line in enumerate(lines) if line.strip()]
    return tuple(line.rstrip() for line in lines[full[0] : full[-1] + 1]) if full else ()


def _program(tree: Tree, path: Path, name: str) -> str:
    stem = path.parent.name
    if name in (SOLUTION, STARTER):
        exercise = source.load(tree.solutions / f"{stem}.py")
        return exercise.solution_code if name == SOLUTION else exercise.starter_code
    folder, _, file = name.partition("/")
    right = tree.right_answers / stem / file
    if folder != "right" or not file or not right.is_file():
        raise WrongAnswerError(path, 1, f"'# on: {name}': write {SOLUTION}, {STARTER} or right/NAME.py")
    return read_answer(right, stem).text


def _changed(path: Path, base: str, changes: Sequence[Change]) -> str:
    lines = base.splitlines()
    places: dict[int, tuple[int, list[str]]] = {}
    taken: set[int] = set()
    for change in changes:
        count, wanted = len(change.old), _dedented(change.old)
        found = [at for at in range(len(lines)) if _dedented(lines[at : at + count]) == wanted]
        if len(found) != 1:
            raise WrongAnswerError(
                path,
                change.line,
                f"must be found once in the program, not {len(found)} times:\n" + "\n".join(change.old),
            )
        span = range(found[0], found[0] + count)
        if taken.intersection(span):
            raise WrongAnswerError(path, change.line, "changes lines that another change has changed already")
        taken.update(span)
        shift = _depth(lines[span.start : span.stop]) - _depth(change.old)
        if shift < -_depth(change.new):
            raise WrongAnswerError(
                path,
                change.line,
                "its lines are indented more here than in the program, but the new code is not",
            )
        places[span.start] = count, [_moved(line, shift) for line in change.new]
    result: list[str] = []
    at = 0
    while at < len(lines):
        count, new = places.get(at, (1, lines[at : at + 1]))
        result += new
        at += count
    return "\n".join(result) + "\n"


def _dedented(lines: Sequence[str]) -> tuple[str, ...]:
    return tuple(textwrap.dedent("\n".join(line.rstrip() for line in lines)).split("\n"))


def _depth(lines: Sequence[str]) -> int:
    """Return the number of spaces that all lines begin with, ignoring blank lines."""
    return min((len(line) - len(line.lstrip(" ")) for line in lines if line.strip()), default=0)


def _moved(line: str, shift: int) -> str:
    if not line.strip():
        return ""
    return " " * shift + line if shift >= 0 else line[-shift:]


def _compile_problem(text: str) -> str:
    """Return the reason why Python can't compile a program, or "" if Python can compile it."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            compile(text, "answer.py", "exec", dont_inherit=True)
    except (SyntaxError, ValueError) as error:
        return f"{error}"
    return ""
