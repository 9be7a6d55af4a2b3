"""Reports on mutants, `tests/mutants/NN_slug.toml`: counts, and each mutant that got full marks.

`make mutants` writes them. It keeps the parts that authors write: `right`, `judged_here`, `[[free]]`, and the reasons.
"""

import json
import tomllib
from collections import Counter
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any

from workbook.authoring.mutants.making import Mutant
from workbook.authoring.tree import AuthoringError

HOLE, ACCEPTED = "hole: ", "accepted: "
HEAD = """\
# Written by `make mutants`. Yours to write, and kept: `right` (the programs besides the solution), `judged_here`
# (classes of mutants that are no excuse in this exercise), [[free]] (places where the task leaves the choice), and
# each `reason`: "accepted: why a teacher accepts it", or "hole: what the judge does not see".
"""


@dataclass(frozen=True)
class Free:
    """A place where the task leaves the choice to the student. Mutants that survive there are accepted, for `reason`.

    `scope`, `code`, and `base` are patterns for a mutant's scope, original lines, and base. If `operators` is empty, it
    matches all operators.
    """

    reason: str
    scope: str = "*"
    code: str = "*"
    operators: tuple[str, ...] = ()
    base: str = "*"

    def covers(self, mutant: Mutant) -> bool:
        """Return whether a mutant changes the code at this place."""
        return (
            fnmatchcase(mutant.scope, self.scope)
            and fnmatchcase(mutant.before, self.code)
            and fnmatchcase(mutant.base, self.base)
            and (not self.operators or mutant.operator in self.operators)
        )


@dataclass(frozen=True)
class Survivor:
    """A mutant that got full marks.

    `reason` says why the mutant is accepted, or which hole in the judge it reveals. It's empty until an author fills it
    in.
    """

    id: str
    base: str
    operator: str
    scope: str
    before: str
    after: str
    reason: str = ""

    @property
    def accepted(self) -> bool:
        """Whether an author has accepted this mutant."""
        return self.reason.startswith(ACCEPTED)


@dataclass(frozen=True)
class Report:
    """The result for one exercise.

    `judged` = `killed` + `accepted` + `survived`. `accepted_as` counts mutants accepted for a class or a free place.
    `killed_by` counts the mutants by the first criterion that they lost. `inputs` are hashes of the report's inputs.
    """

    exercise: str
    made: int = 0
    judged: int = 0
    killed: int = 0
    accepted: int = 0
    survived: int = 0
    right: tuple[str, ...] = ()
    judged_here: tuple[str, ...] = ()
    inputs: Mapping[str, str] = field(default_factory=dict)
    accepted_as: Mapping[str, int] = field(default_factory=dict)
    killed_by: Mapping[str, int] = field(default_factory=dict)
    free: tuple[Free, ...] = ()
    survivors: tuple[Survivor, ...] = ()

    def excuse(self, mutant: Mutant) -> str | None:
        """Return the reason why a mutant is accepted, which is its class or a free place's reason, or None."""
        for name in mutant.classes:
            if name not in self.judged_here:
                return name
        return next((one.reason for one in self.free if one.covers(mutant)), None)

    def summary(self) -> str:
        """Return the counts in one line."""
        holes = sum(one.reason.startswith(HOLE) for one in self.survivors)
        unread = sum(not one.reason for one in self.survivors)
        kinds = f" ({holes} holes, {unread} not looked at)" if self.survived else ""
        return (
            f"{self.exercise}: {self.made} made, {self.judged} judged: {self.killed} killed, "
            f"{self.accepted} accepted, {self.survived} survived{kinds}"
        )


def filled(before: Report, made: int, judged: Mapping[str, tuple[Mutant, tuple[str, ...]]]) -> Report:
    """Return the report of a new run. Keep the reasons and the authors' parts of the earlier report, `before`.

    `judged` contains each judged mutant with the criteria that it lost.
    """
    reasons = {one.id: one.reason for one in before.survivors}
    accepted_as, killed_by = Counter[str](), Counter[str]()
    survivors: list[Survivor] = []
    for mutant, lost in judged.values():
        if lost:
            killed_by[lost[0]] += 1
        elif excuse := before.excuse(mutant):
            accepted_as[excuse] += 1
        else:
            survivors.append(_survivor(mutant, reasons.get(mutant.id, "")))
    by_hand = sum(one.accepted for one in survivors)
    return replace(
        before,
        made=made,
        judged=len(judged),
        killed=killed_by.total(),
        accepted=accepted_as.total() + by_hand,
        survived=len(survivors) - by_hand,
        accepted_as=dict(sorted(accepted_as.items())),
        killed_by=dict(killed_by.most_common()),
        survivors=tuple(sorted(survivors, key=lambda one: (one.accepted, one.base, one.scope, one.id))),
    )


def _survivor(mutant: Mutant, reason: str) -> Survivor:
    return Survivor(
        mutant.id, mutant.base, mutant.operator, mutant.scope, mutant.before, mutant.after, reason
    )


def read_report(path: Path) -> Report:
    """Read a report from a file. If there is no file, return an empty report.

    Raises AuthoringError if the file isn't a report.
    """
    if not path.is_file():
        return Report(path.stem)
    try:
        data: dict[str, Any] = tomllib.loads(path.read_text(encoding="utf-8"))
        free = [Free(**{**one, "operators": tuple(one.get("operators", ()))}) for one in data.pop("free", ())]
        survivors = [Survivor(**one) for one in data.pop("survivor", ())]
        right, judged_here = tuple(data.pop("right", ())), tuple(data.pop("judged_here", ()))
        return Report(
            **data, right=right, judged_here=judged_here, free=tuple(free), survivors=tuple(survivors)
        )
    except (tomllib.TOMLDecodeError, TypeError) as error:
        raise AuthoringError(f"{path}: {error}") from error


def write_report(report: Report, path: Path) -> None:
    """Write a report as TOML, in an order that makes diffs easy to read."""
    path.parent.mkdir(parents=True, exist_ok=True)
    lines = [HEAD.rstrip()]
    tables: list[str] = []
    for one in fields(report):
        value = getattr(report, one.name)
        if isinstance(value, Mapping):
            tables += ["", f"[{one.name}]", *(f"{_text(key)} = {_text(item)}" for key, item in value.items())]
        elif one.name == "free":
            for place in value:
                tables += ["", "[[free]]", *_pairs(_without_defaults(place))]
        elif one.name == "survivors":
            for survivor in value:
                tables += ["", "[[survivor]]", *_pairs(asdict(survivor))]
        else:
            lines.append(f"{one.name} = {_text(value)}")
    path.write_text("\n".join([*lines, *tables]) + "\n", encoding="utf-8")


def _without_defaults(place: Free) -> dict[str, Any]:
    return {
        one.name: getattr(place, one.name) for one in fields(place) if getattr(place, one.name) != one.default
    }


def _pairs(values: Mapping[str, Any]) -> list[str]:
    return [f"{name} = {_text(value)}" for name, value in values.items()]


def _text(value: object) -> str:
    """Return a string, a number, or a tuple of strings as TOML, which has the same syntax for them as JSON."""
    return json.dumps(list(value) if isinstance(value, tuple) else value, ensure_ascii=False)
