"""A prediction as data: its options, why each of them is right or wrong, and how a run decides between them."""

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Option:
    """One thing that may happen. `when` is a condition on what the run measured, or empty."""

    letter: str
    text: str
    why: str
    when: str = ""


@dataclass(frozen=True)
class Prediction:
    """A question that a lesson asks before a run. `usual` is the letter of what happens as a rule."""

    name: str
    options: tuple[Option, ...]
    usual: str

    @property
    def letters(self) -> str:
        """The letters to choose from, in words: a, b or c."""
        *most, last = [option.letter for option in self.options]
        return f"{', '.join(most)} or {last}"

    def letter_of(self, choice: str) -> str | None:
        """The letter that a choice begins with, "b) 60" for example; None when no option has it."""
        first = choice.strip(" \t\n\"'([*").casefold()[:1]
        return first if any(option.letter == first for option in self.options) else None

    def option(self, letter: str) -> Option:
        """The option of a letter."""
        return next(option for option in self.options if option.letter == letter)

    def decided_by(self, measured: Mapping[str, object]) -> str | None:
        """The letter of what happened in this run; None when it fits no option, or more than one.

        Where no option has a condition, a run cannot decide, and it is what happens as a rule.
        """
        conditions = {option.letter: option.when for option in self.options if option.when}
        if not conditions:
            return self.usual
        fits = [letter for letter, when in conditions.items() if _holds(when, measured)]
        return fits[0] if len(fits) == 1 else None


def _holds(condition: str, measured: Mapping[str, object]) -> bool:
    # The conditions are the course's own, and the build lets only comparisons through.
    return bool(eval(condition, {"__builtins__": {}}, dict(measured)))
