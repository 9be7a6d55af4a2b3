"""Choose a verdict's cause from an ordered table, and take the verdict's wording from a catalog.

A criterion has three separate parts:

- **Facts**: the events, described in the exercise's own terms. They are the attributes of a class whose `__init__`
  computes them from a recording, from top to bottom. If some facts are expensive and seldom needed, use a frozen
  dataclass with `cached_property`.
- **Rules**: an ordered table of causes, each with an id and a predicate over the facts. The first match is the cause.
- **Words**: a catalog of feedback strings, the file `name.toml` next to `name.py`. `[in-order.late]` contains `saw`,
  `expected`, `because`, and `try` for the cause "in-order.late"; missing parts are taken from `[in-order]`. `{name}` is
  filled in from the facts, and `{lost:n}` is the length of `lost`. `{lost|is|are}` chooses the singular or the plural.
  `{texts.name}` is a string from `[texts]`, which several causes may share. `{AT_ONCE_S}` and `{LEAST_SHARE:.0%}` are
  constants of the module, if it passes them: `Words(__file__, globals())`.

Importing a module raises CatalogError if its causes and its catalog's entries don't match, or if a placeholder isn't a
fact.
"""

import re
import tomllib
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence, Sized
from dataclasses import dataclass, fields, is_dataclass
from dis import get_instructions
from functools import cached_property
from pathlib import Path
from string import Formatter
from types import MappingProxyType, ModuleType
from typing import Any, Generic, TypeVar

from workbook.criteria.verdict import Verdict, failed, partial
from workbook.criteria.vocabulary.phrasing import listing, number
from workbook.recording.recording import Recording

PARTS = ("saw", "expected", "because", "try")
SEEN, REASON = PARTS[:2], PARTS[2:]
TEXTS = "texts"
F = TypeVar("F")
Given = type | Collection[str]
"""The source of a feedback string's placeholders: a class of facts, or the names of keyword arguments."""
Blame = Callable[[Recording, str, str], Verdict | None]
"""A function that looks for a cause in a recording, such as an error that made the program exit.

The function takes the recording and the strings `saw` and `expected`. It returns a failed verdict, or None if it
doesn't find a cause.
"""
Rule = tuple[str, Callable[[F], object]] | tuple[str, Callable[[F], object], Blame]
"""A cause and the predicate that selects it. An optional third element looks for another cause first."""


class CatalogError(ValueError):
    """Raised when a module's catalog doesn't match the causes that the module declares.

    The message names the file and the entry.
    """


class _Filler(Formatter):
    """Fills in placeholders. Floats are formatted without an exponent, and a list of names becomes an English list.

    `{lost:n}` is the length of `lost`, and `{lost|is|are}` chooses the singular or the plural. `{lost:times}` is
    "once", "twice", or "3 times".
    """

    def get_field(self, field_name: str, args: Any, kwargs: Mapping[str, Any]) -> tuple[Any, str]:
        name, *forms = field_name.split("|")
        value, used = super().get_field(name, args, kwargs)
        if forms:
            one, many = forms
            return (one if (value if isinstance(value, (int, float)) else len(value)) == 1 else many), used
        return value, str(used)

    def format_field(self, value: Any, format_spec: str) -> str:
        if isinstance(value, float) and not format_spec:
            return number(value)
        if isinstance(value, (list, tuple)) and not format_spec:
            return listing([self.format_field(one, "") for one in value])
        if isinstance(value, Sized) and format_spec == "n":
            return str(len(value))
        if format_spec == "times":
            n = len(value) if isinstance(value, Sized) else value
            return {1: "once", 2: "twice"}.get(n, f"{n} times")
        return str(super().format_field(value, format_spec))


_FILLER = _Filler()
_CONSTANT = re.compile(r"(?<!\{)\{([A-Z][A-Z0-9_]*)(?::([^}]*))?\}(?!\})")


class _OfFacts(Mapping[str, Any]):
    """A mapping from an object's attribute names to their values, for looking up placeholders."""

    def __init__(self, facts: object) -> None:
        self._facts = facts

    def __getitem__(self, name: str) -> Any:
        return getattr(self._facts, name)

    def __iter__(self) -> Iterator[str]:
        return iter(dir(self._facts))

    def __len__(self) -> int:
        return len(dir(self._facts))


def _names(given: type) -> set[str]:
    """Return the attributes of a class of facts, including those that its `__init__` sets."""
    set_by_init = {
        step.argval
        for one in given.__mro__[:-1]
        if "__init__" in vars(one)
        for step in get_instructions(vars(one)["__init__"])
        if step.opname == "STORE_ATTR"
    }
    return {
        *dir(given),
        *set_by_init,
        *((field.name for field in fields(given)) if is_dataclass(given) else ()),
    }


def _filled_in(
    words: Mapping[str, str], parts: Sequence[str], facts: object, given: Mapping[str, Any]
) -> list[str]:
    values = given if facts is None else _OfFacts(facts)
    return [_FILLER.vformat(words[part], (), values) for part in parts]


@dataclass(frozen=True)
class Cause:
    """A cause: its feedback strings, and the flags of its verdict (see `Verdict`).

    If `share` isn't 0, the verdict gives that fraction of the points as partial credit.
    """

    id: str
    words: Mapping[str, str]
    about_time: bool = False
    recheck_fields: bool = False
    share: float = 0.0

    def verdict(self, facts: object = None, *, about_time: bool | None = None, **given: Any) -> Verdict:
        """Return a verdict whose feedback strings are filled in from facts or keyword arguments.

        `about_time`, if given, overrides the cause's own flag.
        """
        told = _filled_in(self.words, PARTS, facts, given)
        timed = self.about_time if about_time is None else about_time
        if self.share:
            return partial(self.id, self.share, *told, about_time=timed)
        return failed(self.id, *told, about_time=timed, recheck_fields=self.recheck_fields)


@dataclass(frozen=True)
class Observation:
    """The strings `saw` and `expected` of a verdict whose cause isn't known yet.

    They're passed to a function that looks for the cause, such as an exception that made the program exit.
    """

    words: Mapping[str, str]

    def __call__(self, facts: object = None, **given: Any) -> tuple[str, str]:
        """Return `saw` and `expected`, filled in from facts or keyword arguments.

        For example: `see.ended_by_error(recording, *NOTHING(facts))`.
        """
        saw, expected = _filled_in(self.words, SEEN, facts, given)
        return saw, expected


@dataclass(frozen=True)
class Blamed:
    """A row of a table for which `blame` first looks for a cause, such as an error.

    If `blame` doesn't find one, `cause` is the fallback. If `cause` is None, too, the row doesn't give a verdict.
    """

    id: str
    words: Mapping[str, str]
    blame: Blame
    cause: Cause | None

    def verdict(self, facts: Any) -> Verdict | None:
        """Return the verdict from `blame`, or else the fallback cause's verdict, or None if there is neither."""
        found = self.blame(facts.recording, *_filled_in(self.words, SEEN, facts, {}))
        return found or (self.cause.verdict(facts) if self.cause else None)


@dataclass(frozen=True)
class Reason:
    """The strings `because` and `try` for an error that a table recognizes.

    The strings `saw` and `expected` come from another rule.
    """

    id: str
    words: Mapping[str, str]

    def __call__(self, facts: object = None, **given: Any) -> tuple[str, str]:
        """Return `because` and `try`, filled in from facts or keyword arguments."""
        because, try_this = _filled_in(self.words, REASON, facts, given)
        return because, try_this


def otherwise(facts: object) -> bool:
    """Return True for any facts. Use it in the last rule of a table."""
    return True


@dataclass(frozen=True)
class Rules(Generic[F]):
    """An ordered table of causes, each with its predicate. If `when` is false for the facts, no cause matches."""

    table: tuple[tuple[Cause | Blamed, Callable[[F], object]], ...]
    when: Callable[[F], object] = otherwise

    def first(self, facts: F) -> Verdict | None:
        """Return the verdict of the first cause that matches the facts, or None if no cause does."""
        if not self.when(facts):
            return None
        found = (cause.verdict(facts) for cause, fits in self.table if fits(facts))
        return next(filter(None, found), None)

    def verdict(self, facts: F) -> Verdict:
        """Return the same verdict as `first`, for a table in which a cause always matches.

        Raises LookupError if no cause matches.
        """
        found = self.first(facts)
        if found is None:
            raise LookupError(f"no rule fits, of {[cause.id for cause, _ in self.table]}")
        return found


class Words:
    """A module's catalog of feedback strings: a TOML file next to the module, with the same name.

    `constants`: the values of the uppercase placeholders.

    Raises CatalogError if an entry lacks one of its four parts.
    """

    def __init__(self, module_file: str, constants: Mapping[str, Any] = MappingProxyType({})) -> None:
        self.path = Path(module_file).with_suffix(".toml")
        self._constants = constants
        self._used: set[str] = set()
        self._names_of: dict[type, set[str]] = {}

    @cached_property
    def entries(self) -> dict[str, dict[str, str]]:
        """All entries by name, including the parts that they share through their section or `[texts]`."""
        sections = tomllib.loads(self.path.read_text(encoding="utf-8"))
        shared = {f"{{{TEXTS}.{name}}}": text for name, text in sections.pop(TEXTS, {}).items()}

        def with_shared(text: str) -> str:
            for placeholder, words in shared.items():
                text = text.replace(placeholder, words)
            return text

        return {
            f"{word}.{reason}": {
                part: with_shared(text)
                for part, text in {**section, **entry}.items()
                if not isinstance(text, dict)
            }
            for word, section in sections.items()
            for reason, entry in section.items()
            if isinstance(entry, dict)
        }

    def cause(
        self,
        cause: str,
        given: Given,
        *,
        about_time: bool = False,
        recheck_fields: bool = False,
        share: float = 0.0,
    ) -> Cause:
        """Declare one cause. `given`: a class of facts, or the names of the keyword arguments for its verdicts.

        Raises CatalogError if the catalog has no entry for the cause, or if a placeholder isn't in `given`.
        """
        return Cause(cause, self._checked(cause, PARTS, given), about_time, recheck_fields, share)

    def seen(self, name: str, given: Given) -> Observation:
        """Declare the strings `saw` and `expected` under a name such as "in-order.by-error".

        The catalog entry contains only these two parts; another rule finds the cause. Raises CatalogError as `cause`
        does.
        """
        return Observation(self._checked(name, SEEN, given))

    def reason(self, name: str, given: Given = ()) -> Reason:
        """Declare a reason and a next step. The catalog entry contains only `because` and `try`.

        Raises CatalogError as `cause` does.
        """
        return Reason(name, self._checked(name, REASON, given))

    def rules(
        self,
        facts: type[F],
        word: str,
        *rules: Rule[F],
        when: Callable[[F], object] = otherwise,
        about_time: bool | Collection[str] = False,
        recheck_fields: bool | Collection[str] = False,
        share: float = 0.0,
    ) -> Rules[F]:
        """Declare a table of causes. Each row has the cause's id without `word`, and a predicate over the facts.

        An optional third element, such as `see.program_ended`, looks for a cause in the facts' recording, and that
        cause takes precedence. If this function doesn't find a cause, and the row's catalog entry has only `saw` and
        `expected`, the next rows are tried. `when`: a condition over the facts for the whole table. `about_time` and
        `recheck_fields`: True to set the flag for every cause that has a catalog entry, or the reasons (ids without
        `word`) of some causes. Raises CatalogError as `cause` does.
        """

        def of(reason: str, which: bool | Collection[str]) -> bool:
            return which if isinstance(which, bool) else reason in which

        def row(reason: str, blame: Sequence[Blame]) -> Cause | Blamed:
            name = f"{word}.{reason}"
            timed, recheck = of(reason, about_time), of(reason, recheck_fields)
            if blame and "recording" not in _names(facts):
                raise CatalogError(f"{self.path}: {name}: the facts have no recording to find a cause in")
            if blame and name not in self.causes():
                return Blamed(name, self.seen(name, facts).words, blame[0], None)
            cause = self.cause(name, facts, about_time=timed, recheck_fields=recheck, share=share)
            return Blamed(name, cause.words, blame[0], cause) if blame else cause

        return Rules(tuple((row(reason, blame), fits) for reason, fits, *blame in rules), when)

    def _checked(self, name: str, parts: Sequence[str], given: Given) -> dict[str, str]:
        words = self.entries.get(name)
        if words is None:
            raise CatalogError(f"{self.path}: {name} has no words")
        if set(words) != set(parts):
            odd = listing(sorted(set(words) ^ set(parts)))
            raise CatalogError(
                f"{self.path}: {name} has the parts {listing(parts)}, and no others: see {odd}"
            )
        words = {part: _CONSTANT.sub(self._constant, text) for part, text in words.items()}
        known = self._known(given)
        for part, text in words.items():
            for placeholder in placeholders(text) - known:
                raise CatalogError(f"{self.path}: {name}, {part}: nothing is called {{{placeholder}}} here")
        self._used.add(name)
        return words

    def _constant(self, found: re.Match[str]) -> str:
        name, how = found.groups(default="")
        if name not in self._constants:
            raise CatalogError(f"{self.path}: the module has no constant {name}")
        return _FILLER.format_field(self._constants[name], how)

    def _known(self, given: Given) -> set[str]:
        """Return the names that placeholders may use. A class is inspected only once, because many causes share it."""
        if not isinstance(given, type):
            return set(given)
        if given not in self._names_of:
            self._names_of[given] = _names(given)
        return self._names_of[given]

    def causes(self) -> set[str]:
        """Return the ids of all causes in this catalog."""
        return {name for name, entry in self.entries.items() if "because" in entry}

    def refuse_leftovers(self) -> None:
        """Raise CatalogError if the catalog has an entry that no declared cause uses."""
        left = sorted(self.entries.keys() - self._used)
        if left:
            raise CatalogError(f"{self.path}: no cause in the module uses the words of {listing(left)}")


def placeholders(text: str) -> set[str]:
    """Return the names with which a string's placeholders begin, such as "lost" for `{lost:n}`."""
    return {
        name.split("|")[0].split(".")[0].split("[")[0]
        for _, name, _, _ in Formatter().parse(text)
        if name is not None
    }


def refuse_leftovers(module: ModuleType) -> None:
    """Raise CatalogError if a module's catalog has an entry that none of the module's causes uses."""
    for value in vars(module).values():
        if isinstance(value, Words):
            value.refuse_leftovers()
