"""`workbook node`, `workbook topic` and `workbook graph`: the ROS graph of the open notebook in a terminal."""

import argparse
import math
import os
import sys
from collections.abc import Callable
from typing import Any

from workbook.ros.environment import prepare
from workbook.ros.notebook_registry import OpenNotebook, open_notebooks


class NoChoice(Exception):
    """Several notebooks are open and there is no terminal to ask which is meant."""


def register(subparsers: Any) -> None:
    """Add the subcommands."""
    node = subparsers.add_parser("node", help="the running nodes").add_subparsers(
        title="commands", metavar="COMMAND", required=True
    )
    topic = subparsers.add_parser(
        "topic", help="the topics in use, what is said on them, how often"
    ).add_subparsers(title="commands", metavar="COMMAND", required=True)
    _command(node, "list", "all nodes", lambda tools, options: tools.node_list(hidden=options.hidden))
    one = _command(
        node,
        "info",
        "what one node does",
        lambda tools, options: tools.node_info(options.name, hidden=options.hidden),
    )
    one.add_argument("name", help="for example /humanoid_status")
    _command(
        topic, "list", "all topics with their types", lambda t, options: t.topic_list(hidden=options.hidden)
    )
    info = _command(
        topic,
        "info",
        "who publishes, who subscribes, with which QoS",
        lambda t, o: t.topic_info(o.topic, hidden=o.hidden),
    )
    echo = _command(topic, "echo", "print messages as they come", _echo)
    echo.add_argument("--count", type=_positive, help="end after this many messages")
    echo.add_argument("--timeout", type=float, default=math.inf, metavar="S", help="end after S seconds")
    hz = _command(topic, "hz", "measure how often messages come", _hz)
    hz.add_argument("--seconds", type=float, default=5.0, metavar="S", help="for how long (default 5)")
    for parser in (info, echo, hz):
        parser.add_argument("topic", help="for example /robot/status")
    _command(
        subparsers, "graph", "who talks to whom", lambda tools, options: tools.graph(hidden=options.hidden)
    )


def _positive(text: str) -> int:
    number = int(text)
    if number < 1:
        raise ValueError
    return number


def _command(subparsers: Any, name: str, help_text: str, query: Callable[[Any, Any], Any]) -> Any:
    parser = subparsers.add_parser(
        name, help=help_text, description=help_text[0].upper() + help_text[1:] + "."
    )
    parser.add_argument(
        "--domain", type=int, metavar="N", help="ROS domain (default: that of the open notebook)"
    )
    parser.add_argument("--hidden", action="store_true", help="show what is usually left out, too")
    parser.set_defaults(run=lambda options: _run(options, query))
    return parser


def _run(options: argparse.Namespace, query: Callable[[Any, Any], Any]) -> int:
    try:
        domain_id = choose_domain(options.domain, open_notebooks(), os.environ.get("ROS_DOMAIN_ID"))
    except NoChoice as error:
        print(error, file=sys.stderr)
        return 2
    prepare(domain_id=domain_id, check_fields=False)
    import workbook.ros as tools
    from workbook.ros import exit_cleanup

    exit_cleanup.register()
    try:
        shown = query(tools, options)
    except LookupError as error:
        print(error, file=sys.stderr)
        return 1
    if shown is not None:
        print(shown)
    return 0


def _echo(tools: Any, options: argparse.Namespace) -> Any:
    from workbook.ros.topic_monitor import message_text

    def show(message: Any) -> None:
        print(f"{message_text(message)}\n---", flush=True)

    echo = tools.topic_echo(options.topic, options.count, options.timeout, on_message=show)
    return None if echo.messages else echo


def _hz(tools: Any, options: argparse.Namespace) -> Any:
    return tools.topic_hz(options.topic, options.seconds)


def choose_domain(asked: int | None, notebooks: list[OpenNotebook], in_environment: str | None) -> int:
    """The domain to look at: the one asked for, that of the open notebook, or that of the environment.

    With several open notebooks it asks at a terminal, and raises NoChoice elsewhere.
    """
    if asked is not None:
        return asked
    fallback = int(in_environment) if in_environment and in_environment.isdigit() else 0
    if not notebooks:
        print(f"No notebook is open. Looking at domain {fallback}.", file=sys.stderr)
        return fallback
    fitting = [notebook for notebook in notebooks if notebook.domain_id == fallback]
    if len(notebooks) == 1 or fitting:
        return (fitting or notebooks)[0].domain_id
    menu = [
        f"  {place}  {notebook.label} (domain {notebook.domain_id})"
        for place, notebook in enumerate(notebooks, 1)
    ]
    print("\n".join(["Several notebooks are open:", *menu]), file=sys.stderr)
    if not sys.stdin.isatty():
        raise NoChoice("Say which with --domain N.")
    while True:
        print(f"Which one (1 to {len(notebooks)})? ", end="", file=sys.stderr, flush=True)
        answer = sys.stdin.readline()
        if not answer:
            raise NoChoice("\nSay which with --domain N.")
        if answer.strip().isdigit() and 1 <= int(answer) <= len(notebooks):
            return notebooks[int(answer) - 1].domain_id
