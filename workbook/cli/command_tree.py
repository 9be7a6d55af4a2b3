"""The commands with their options and places as plain data, read from the parser: what shell completion is made of."""

import argparse
from collections.abc import Iterator
from dataclasses import dataclass

from workbook.cli.parsing import CommandParser

FILES = "files"
EXERCISES = "exercises"
TOPICS = "topics"
_KIND_OF = {"EXERCISE": EXERCISES, "ID": EXERCISES, "TOPIC": TOPICS}
_LONGEST = 60
_MANY = 5


@dataclass(frozen=True)
class Wanted:
    """What may stand in one place: words of a kind (FILES, EXERCISES, TOPICS), or these; anything if both are empty."""

    kind: str = ""
    words: tuple[str, ...] = ()


@dataclass(frozen=True)
class CommandOption:
    """One option under its long name, what it does, and its value if it takes one."""

    name: str
    text: str
    value: Wanted | None


@dataclass(frozen=True)
class Command:
    """A command: its words after `workbook`, the commands below with what they do, its options, its places in order.

    A place that takes any number of words is there several times.
    """

    words: tuple[str, ...]
    below: dict[str, str]
    options: tuple[CommandOption, ...]
    places: tuple[Wanted, ...]


def commands_of(parser: CommandParser, words: tuple[str, ...] = ()) -> Iterator[Command]:
    """This command and all below it."""
    places = [one for one in parser.arguments if not one.option_strings]
    yield Command(
        words,
        {name: _short(text) for name, text in parser.briefly.items()},
        tuple(_option(one) for one in parser.arguments if one.option_strings),
        tuple(_wanted(one) for one in places for _ in range(_MANY if one.nargs in ("*", "+") else 1)),
    )
    for name, inner in parser.below.items():
        yield from commands_of(inner, (*words, name))


def _option(action: argparse.Action) -> CommandOption:
    takes_value = action.nargs != 0
    return CommandOption(
        action.option_strings[-1], _short(action.help or ""), _wanted(action) if takes_value else None
    )


def _wanted(action: argparse.Action) -> Wanted:
    if action.choices is not None:
        return Wanted(words=tuple(map(str, action.choices)))
    if getattr(action.type, "__name__", "") == "Path":
        return Wanted(FILES)
    return Wanted(_KIND_OF.get(str(action.metavar), ""))


def _short(text: str) -> str:
    """A few words that no shell reads as anything else."""
    plain = "".join(letter for letter in text.replace("%%", "%") if letter not in "\"'`$\\[]{}:;()%")
    return plain if len(plain) <= _LONGEST else f"{plain[: _LONGEST - 1].rstrip()}…"
