"""`workbook node`, `workbook topic`, and `workbook graph`: inspect the open notebook's ROS graph in a terminal."""

import argparse
import math
import os
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

from workbook.cli import terminal
from workbook.inside.proc import udp_ports_in_use
from workbook.ros.domains import dds_port_range
from workbook.ros.environment import prepare
from workbook.ros.notebook_registry import OpenNotebook, open_notebooks

_LAST_DOMAIN = 232
"""The highest domain ID that ROS allows."""


class NoChoice(Exception):
    """Raised when several notebooks are open, but there is no terminal to ask the user which one to inspect."""


def register(subparsers: Any) -> None:
    """Add the subcommands."""
    node = subparsers.add_parser("node", help="the running nodes").add_subparsers(
        title="commands", metavar="COMMAND", required=True
    )
    topic = subparsers.add_parser(
        "topic", help="the topics in use, their messages, and their rates"
    ).add_subparsers(title="commands", metavar="COMMAND", required=True)
    _command(node, "list", "all nodes", lambda tools, options: tools.node_list(hidden=options.hidden))
    one = _command(
        node,
        "info",
        "what one node does",
        lambda tools, options: tools.node_info(options.name, hidden=options.hidden),
    )
    one.add_argument("name", metavar="NODE", help="for example /humanoid_status")
    _command(
        topic, "list", "all topics with their types", lambda t, options: t.topic_list(hidden=options.hidden)
    )
    info = _command(
        topic,
        "info",
        "who publishes, who subscribes, with which QoS",
        lambda t, o: t.topic_info(o.topic, hidden=o.hidden),
    )
    echo = _command(topic, "echo", "print messages as they arrive", _echo)
    echo.add_argument("--count", type=_positive, metavar="N", help="end after this many messages")
    echo.add_argument("--timeout", type=_seconds, default=math.inf, metavar="S", help="end after S seconds")
    hz = _command(topic, "hz", "measure how often messages arrive", _hz)
    hz.add_argument("--seconds", type=_seconds, default=5.0, metavar="S", help="for how long (default 5)")
    for parser in (info, echo, hz):
        parser.add_argument("topic", metavar="TOPIC", help="for example /robot/status")
    _command(
        subparsers, "graph", "who talks to whom", lambda tools, options: tools.graph(hidden=options.hidden)
    )


def _positive(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"{text} is not a whole number of 1 or more")
    return int(text)


def _seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = -1.0
    if not seconds > 0:
        raise argparse.ArgumentTypeError(f"{text} is not a number of seconds")
    return seconds


def _domain(text: str) -> int:
    if not text.isdecimal() or int(text) > _LAST_DOMAIN:
        raise argparse.ArgumentTypeError(
            f"{text} is not a ROS domain. Domains are numbers from 0 to {_LAST_DOMAIN}"
        )
    return int(text)


def _command(subparsers: Any, name: str, help_text: str, query: Callable[[Any, Any], Any]) -> Any:
    parser = subparsers.add_parser(
        name, help=help_text, description=help_text[0].upper() + help_text[1:] + "."
    )
    parser.add_argument(
        "--domain", type=_domain, metavar="N", help="ROS domain (default: the open notebook's)"
    )
    parser.add_argument("--hidden", action="store_true", help="also show usually hidden nodes and topics")
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
    from workbook.ros.tables import Shown

    exit_cleanup.register()
    try:
        shown = query(tools, options)
    except LookupError as error:
        still = f"Still no node publishes {options.topic}." if getattr(options, "said_who", False) else error
        terminal.say(str(still), sys.stderr)
        return 1
    if shown is not None:
        print(shown.text(terminal.width()) if isinstance(shown, Shown) else shown)
    return 0


def _echo(tools: Any, options: argparse.Namespace) -> Any:
    from workbook.ros.topic_monitor import message_text

    def show(message: Any) -> None:
        print(f"{message_text(message)}\n---", flush=True)

    echo = tools.topic_echo(
        options.topic,
        options.count,
        options.timeout,
        on_message=show,
        on_silence=_say_who_is_there(options),
        on_held=_say_who_waits,
    )
    return None if echo.messages else replace(echo, held=())


def _hz(tools: Any, options: argparse.Namespace) -> Any:
    """Print the rate every second, and return a summary.

    After Ctrl-C, print the summary, and then raise the exception again.
    """
    from workbook.ros.topic_monitor import rate_of

    topic, began, lines = "/" + options.topic.strip("/"), time.monotonic(), 0
    times: Sequence[float] = ()

    def look(so_far: Sequence[float]) -> None:
        nonlocal times, lines
        times = so_far
        if time.monotonic() - began >= lines + 1.0:
            lines += 1
            print(rate_of(topic, times, lines).line(), flush=True)

    try:
        rate = tools.topic_hz(
            topic,
            options.seconds,
            on_silence=_say_who_is_there(options),
            on_held=_say_who_waits,
            on_look=look,
        )
        return replace(rate, held=())
    except KeyboardInterrupt:
        print(rate_of(topic, times, round(time.monotonic() - began, 1)).text(terminal.width()), flush=True)
        raise


def _say_who_waits(nodes: Sequence[str]) -> None:
    from workbook.ros.topic_monitor import clock_notes

    terminal.say(" ".join(clock_notes(nodes)), sys.stderr)


def _say_who_is_there(options: argparse.Namespace) -> Callable[[Sequence[str]], None]:
    """Return a callback that takes the published topics and prints that the requested topic isn't among them."""
    topic = "/" + options.topic.strip("/")

    def say(published: Sequence[str]) -> None:
        options.said_who = True
        said = [f"No node publishes {topic}.", _topic_meant(topic, published)]
        if published:
            said.append(f"Topics with a publisher: {', '.join(published)}.")
        else:
            said.append("No topic has a publisher. Is a node running?")
        said.append("Waiting for a publisher. Press Ctrl-C to stop.")
        terminal.say(" ".join(filter(None, said)), sys.stderr)

    return say


def _topic_meant(topic: str, published: Sequence[str]) -> str:
    """Return a question that suggests the topic that was probably meant, or "" if there is none.

    If there is a published topic with the same name in a namespace, suggest that one. Otherwise, suggest a similar
    name.
    """
    ending = [name for name in published if name.endswith(topic)]
    return f"Did you mean {ending[0]}?" if ending else terminal.meant(topic, published, cutoff=0.75)


def nodes_on(domain_id: int) -> int:
    """Return the number of nodes that are now on a domain."""
    if not udp_ports_in_use() & set(dds_port_range(domain_id)):
        return 0
    prepare(domain_id=domain_id, check_fields=False)
    from workbook.ros import node_list

    return len(node_list(domain=domain_id))


def choose_domain(
    asked: int | None,
    notebooks: list[OpenNotebook],
    in_environment: str | None,
    count_nodes: Callable[[int], int] = nodes_on,
) -> int:
    """Return the domain to inspect: the requested one, the open notebook's, or the environment's.

    If several notebooks are open and none of them is on the environment's domain, count the nodes on their domains. If
    exactly one of the notebooks has nodes, choose that one, and print its name. Otherwise, ask the user. Raises
    NoChoice if there is no terminal to ask the user.
    """
    if asked is not None:
        return asked
    fallback = int(in_environment) if in_environment and in_environment.isdigit() else 0
    if not notebooks:
        terminal.say(f"No notebook is open. Looking at domain {fallback}.", sys.stderr)
        return fallback
    fitting = [notebook for notebook in notebooks if notebook.domain_id == fallback]
    if len(notebooks) == 1 or fitting:
        return (fitting or notebooks)[0].domain_id
    nodes = {notebook.domain_id: count_nodes(notebook.domain_id) for notebook in notebooks}
    with_nodes = [notebook for notebook in notebooks if nodes[notebook.domain_id]]
    if len(with_nodes) == 1:
        (only,) = with_nodes
        terminal.say(
            f"Looking at {only.label} (domain {only.domain_id}), the only open notebook with nodes.",
            sys.stderr,
        )
        return only.domain_id
    return _ask_which(notebooks, nodes)


def _ask_which(notebooks: list[OpenNotebook], nodes: dict[int, int]) -> int:
    """Let the user choose a notebook from a menu, and return its domain. Raises NoChoice if there is no terminal."""
    print("Several notebooks are open:", file=sys.stderr)
    for place, notebook in enumerate(notebooks, 1):
        count = nodes[notebook.domain_id]
        words = "1 node" if count == 1 else f"{count or 'no'} nodes"
        print(f"  {place}  {notebook.label} (domain {notebook.domain_id}, {words})", file=sys.stderr)
    if not sys.stdin.isatty():
        raise NoChoice("Choose one with --domain N.")
    while True:
        print(f"Which one (1 to {len(notebooks)})? ", end="", file=sys.stderr, flush=True)
        answer = sys.stdin.readline()
        if not answer:
            raise NoChoice("\nChoose one with --domain N.")
        if answer.strip().isdigit() and 1 <= int(answer) <= len(notebooks):
            return notebooks[int(answer) - 1].domain_id
