"""Define predictions as data: the options, why each is right or wrong, and how a run decides between them."""

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Option:
    """A possible outcome. `why` explains it. `when` is a condition on the run's measurements, or empty."""

    letter: str
    text: str
    why: str
    when: str = ""


@dataclass(frozen=True)
class Prediction:
    """A question that a lesson asks before a run. `usual` is the letter of the usual outcome."""

    name: str
    options: tuple[Option, ...]
    usual: str

    @property
    def letters(self) -> str:
        """The letters to choose from, as text, such as "a, b or c"."""
        *most, last = [option.letter for option in self.options]
        return f"{', '.join(most)} or {last}"

    def letter_of(self, choice: str) -> str | None:
        """Return the letter that a choice, such as "b) 60", begins with, or None if no option has that letter."""
        first = choice.strip(" \t\n\"'([*").casefold()[:1]
        return first if any(option.letter == first for option in self.options) else None

    def option(self, letter: str) -> Option:
        """Return the option with this letter."""
        return next(option for option in self.options if option.letter == letter)

    def decided_by(self, measured: Mapping[str, object]) -> str | None:
        """Return the letter of this run's outcome, or None unless `measured` fits exactly one option.

        If no option has a condition, the outcome doesn't depend on the run, so the usual outcome counts.
        """
        conditions = {option.letter: option.when for option in self.options if option.when}
        if not conditions:
            return self.usual
        fits = [letter for letter, when in conditions.items() if _holds(when, measured)]
        return fits[0] if len(fits) == 1 else None


def _holds(condition: str, measured: Mapping[str, object]) -> bool:
    # This is safe, because the conditions come from the course itself, and the build accepts only comparisons.
    return bool(eval(condition, {"__builtins__": {}}, dict(measured)))
