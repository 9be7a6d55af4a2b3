"""Fill the judge's numbers into a task, so that the task can't state a different tolerance than the judge applies.

`{{AT_ONCE_S}}` is a constant in the exercise's criteria file, `{{rates.MEAN_TOLERANCE}}` is one in a vocabulary module,
and `{{plan.simulated_s}}` is a field of the plan. `{{TYPICALLY_S.0}}` is the first of several numbers. With a percent
sign, as in `{{LEAST_SHARE %}}`, the number becomes a percentage, such as "80 %".
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import reduce
from importlib import import_module
from typing import Any

from workbook.criteria.vocabulary.phrasing import number as plain_number
from workbook.exercise.percent_script import SourceError
from workbook.exercise.source import ExerciseSource

_PLACEHOLDER = re.compile(r"\{\{(?P<name>[\w.]+)(?P<percent> %)?\}\}")
_VOCABULARY = "workbook.criteria.vocabulary"


def with_judged_numbers(source: ExerciseSource, known: Mapping[str, Any]) -> ExerciseSource:
    """Return the source with numbers filled into its story and afterword.

    `known`: numbers, or their containers, by name. Raises SourceError for a name that isn't one of the judge's numbers.
    """

    def filled(texts: Sequence[str]) -> tuple[str, ...]:
        return tuple(_PLACEHOLDER.sub(number, text) for text in texts)

    def number(found: re.Match[str]) -> str:
        try:
            value = _value(found["name"], known)
            return f"{100 * value:.0f} %" if found["percent"] else plain_number(value)
        except (AttributeError, ImportError, LookupError, TypeError, ValueError):
            written = source.path.read_text(encoding="utf-8")
            line = written[: written.find(found[0])].count("\n") + 1
            raise SourceError(source.path, line, f"{found[0]} is no number of the judge's") from None

    return replace(source, story=filled(source.story), afterword=filled(source.afterword))


def _value(name: str, known: Mapping[str, Any]) -> Any:
    first, *fields = name.split(".")
    whole = known[first] if first in known else import_module(f"{_VOCABULARY}.{first}")
    return reduce(_part, fields, whole)


def _part(whole: Any, name: str) -> Any:
    return whole[int(name)] if name.isdigit() else getattr(whole, name)
