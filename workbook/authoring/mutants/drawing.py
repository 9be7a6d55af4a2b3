"""Select the mutants to judge if there are too many.

The selection is the same in every run, and draws on all operators and all programs.
"""

import hashlib
from collections import defaultdict
from collections.abc import Callable, Container, Iterable, Iterator, Sequence

from workbook.authoring.mutants.accepted import NEVER_JUDGED
from workbook.authoring.mutants.making import Mutant

MOST = 120


def draw(
    mutants: Iterable[Mutant],
    most: int = MOST,
    *,
    first: Container[str] = (),
    excused: Callable[[Mutant], bool] = lambda mutant: bool(mutant.classes),
) -> list[Mutant]:
    """Select at most `most` mutants. The selection is the same in every run.

    `excused` returns whether full marks are acceptable for a mutant. Unexcused mutants come first, beginning with those
    whose ids are in `first`, and excused ones follow. Mutants of the classes in `accepted.NEVER_JUDGED` are left out.
    """
    judged = [one for one in mutants if not set(one.classes).intersection(NEVER_JUDGED)]
    known = [one for one in judged if one.id in first and not excused(one)]
    others = [one for one in judged if one not in known]
    plain = [one for one in others if not excused(one)]
    rest = [one for one in others if excused(one)]
    return [*known, *_in_turn(plain), *_in_turn(rest)][:most]


def _in_turn(mutants: Sequence[Mutant]) -> Iterator[Mutant]:
    """Yield one mutant per operator and program, then a second one of each, and so on.

    Within a group, the order is pseudorandom, but the same in every run.
    """
    groups: dict[tuple[str, str], list[Mutant]] = defaultdict(list)
    for one in sorted(mutants, key=_lot):
        groups[one.operator, one.base].append(one)
    for number in range(max(map(len, groups.values()), default=0)):
        for group in sorted(groups):
            yield from groups[group][number : number + 1]


def _lot(mutant: Mutant) -> str:
    return hashlib.sha256(mutant.id.encode()).hexdigest()
