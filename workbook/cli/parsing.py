"""Define the parser of the `workbook` command: argparse with grouped help and error messages in plain sentences."""

import argparse
import re
import sys
from collections.abc import Sequence
from typing import Any, NoReturn

from workbook.cli import terminal

Groups = Sequence[tuple[str, Sequence[str]]]
"""The headings of a help page, each with the commands that are listed under it."""
_PLACE = 4
_ARGUMENT = re.compile(r"argument (?P<name>\S+): (?P<what>.*)", re.DOTALL)
_CHOICE = re.compile(r"invalid choice: '?(?P<word>.*?)'? \(choose from")


class _Narrow(argparse.HelpFormatter):
    """Formats help to fit the terminal, in at most 80 columns."""

    def __init__(self, prog: str, **options: Any) -> None:
        super().__init__(prog, **{"max_help_position": 22, "width": terminal.width() - 1, **options})


class CommandParser(argparse.ArgumentParser):
    """A parser for a command and its subcommands.

    After parsing, `options.command` is the parser of the innermost command that was typed.
    """

    def __init__(self, *args: Any, groups: Groups = (), **options: Any) -> None:
        super().__init__(*args, **{"formatter_class": _Narrow, **options})
        self._positionals.title = "arguments"
        self.groups = groups
        self._below: Any = None
        self.set_defaults(command=self)

    def add_subparsers(self, **options: Any) -> Any:
        """Add subparsers as argparse does, but don't treat a missing subcommand as a parser error."""
        self._below = super().add_subparsers(**{**options, "required": False})
        return self._below

    @property
    def below(self) -> dict[str, "CommandParser"]:
        """The subcommands' parsers, keyed by name."""
        return {} if self._below is None else dict(self._below.choices)

    @property
    def briefly(self) -> dict[str, str]:
        """The subcommands' short descriptions, keyed by name."""
        return {} if self._below is None else {one.dest: one.help for one in self._below._get_subactions()}

    @property
    def arguments(self) -> list[argparse.Action]:
        """The command's own options and positional arguments, without its subcommands."""
        return [action for action in self._actions if action is not self._below]

    def format_usage(self) -> str:
        """Return the usage line, in which [OPTIONS] stands for all optional options."""
        self.usage = self._line_to_type()
        return super().format_usage()

    def _line_to_type(self) -> str:
        optional = any(one.option_strings and not one.required for one in self.arguments)
        required = [f"{_name_of(one)} {one.metavar}" for one in self.arguments if _is_required_option(one)]
        places = [_place(one) for one in self.arguments if not one.option_strings]
        words = [
            self.prog,
            *["[OPTIONS]"] * optional,
            *required,
            *places,
            *["COMMAND ..."] * bool(self.below),
        ]
        return terminal.wrapped(" ".join(words), " " * len("usage: ")).lstrip().replace("%", "%%")

    def format_help(self) -> str:
        """Return the help page. If the parser has groups, list the commands by group."""
        self.usage = self._line_to_type()
        if not self.groups:
            return super().format_help()
        page = [f"usage: {self.usage}", "", terminal.wrapped(self.description or "")]
        for heading, names in self._complete_groups():
            page += ["", f"{heading}:", *(line for name in names for line in self._line(name))]
        page += ["", terminal.wrapped(f"`{self.prog} COMMAND --help` explains a command.")]
        return "\n".join([*page, ""])

    def _complete_groups(self) -> Groups:
        """Return the groups that have commands, and then a group of the commands that aren't in any group."""
        named = {name for _, names in self.groups for name in names}
        there = self.briefly
        groups = [(heading, [name for name in names if name in there]) for heading, names in self.groups]
        groups.append(("Other commands", [name for name in there if name not in named]))
        return [(heading, names) for heading, names in groups if names]

    def _line(self, name: str) -> list[str]:
        margin = " " * _PLACE
        column = _PLACE + max(map(len, self.briefly)) + 2
        text = terminal.wrapped(self.briefly[name], " " * column, terminal.width() - 1)
        return f"{margin}{name.ljust(column - _PLACE)}{text[column:]}".split("\n")

    def error(self, message: str) -> NoReturn:
        """Print the problem and the next step in sentences, and exit with code 2."""
        what = f"{self._in_words(message).rstrip('.')}"
        end = "" if what.endswith("?") else "."
        lines = [f"{self.prog}: {what}{end}"]
        if not self.below:
            lines.append(self.format_usage().rstrip())
        lines.append(f"`{self.prog} --help` explains it.")
        self.exit(2, terminal.wrapped("\n".join(lines)) + "\n")

    def _in_words(self, message: str) -> str:
        missing = re.fullmatch(r"the following arguments are required: (.*)", message)
        if missing:
            names = missing[1].split(", ")
            return f"{' and '.join(names)} {'is' if len(names) == 1 else 'are'} missing"
        named = _ARGUMENT.fullmatch(message)
        if named is None:
            return message
        chosen = _CHOICE.match(named["what"])
        if chosen is None:
            return f"{named['name']}: {named['what']}"
        known = next((action.choices for action in self._actions if _name_of(action) == named["name"]), None)
        names = [str(choice) for choice in known or ()]
        guess = terminal.meant(chosen["word"], names)
        kind = "command" if named["name"] == "COMMAND" else named["name"]
        if guess or self.groups:
            return f"there is no {kind} {chosen['word']}. {guess}".rstrip()
        return f"there is no {kind} {chosen['word']}. There is: {', '.join(names)}"

    def refuse(self, rest: Sequence[str]) -> NoReturn:
        """Exit with an error message about the arguments `rest`, which this command doesn't accept."""
        first = rest[0]
        options = [option for action in self.arguments for option in action.option_strings]
        guess = terminal.meant(first.partition("=")[0], options) if first.startswith("-") else ""
        self.error(f"it does not take {first}. {guess}" if guess else f"it does not take {' '.join(rest)}")


def _name_of(action: argparse.Action) -> str:
    """Return the name that argparse uses for an action in error messages."""
    if action.option_strings:
        return "/".join(action.option_strings)
    return action.metavar if isinstance(action.metavar, str) else action.dest


def _is_required_option(action: argparse.Action) -> bool:
    return bool(action.option_strings) and action.required


def _place(action: argparse.Action) -> str:
    """Format a positional argument for the usage line, in brackets if it's optional."""
    name = _name_of(action)
    return {"?": f"[{name}]", "*": f"[{name} ...]", "+": f"{name} ..."}.get(str(action.nargs), name)


def show_what_is_below(parser: CommandParser) -> int:
    """Print a command's subcommands, for a user who typed the command without one. Return the exit code."""
    if parser.groups:
        print(parser.format_help(), end="")
        return 0
    print(
        f"{parser.prog}: the command is missing; try, for example, `{parser.prog} {next(iter(parser.below))}`.",
        file=sys.stderr,
    )
    column = max(map(len, parser.below)) + 6
    for name, text in parser.briefly.items():
        page = terminal.wrapped(text, " " * column, terminal.width() - 1)
        print(f"    {name.ljust(column - 4)}{page[column:]}", file=sys.stderr)
    return 2
