"""Words about the nodes of a program on the graph."""

import difflib
from collections.abc import Collection, Mapping

from workbook.criteria.mishaps import failed_by_error
from workbook.criteria.phrasing import count, listing
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.observing.recording import NodeSeen, Recording


def on_the_graph(
    recording: Recording, name: str, *, beside: Collection[str] = (), how: str | None = None
) -> Verdict:
    """A node of the full name `name`, such as "/robot/left_camera", is on the graph, once.

    `beside`: other nodes of a right program, which are no misspelled one. `how`: what to do when it has another name.
    """
    expected = f"one node {name}"
    found = {node.name: node for node in recording.nodes}
    if name in found and found[name].most == 1:
        return passed(f"{name} is on the graph")
    if name in found:
        return failed(
            f"{found[name].most} nodes are called {name}",
            expected,
            "ROS does not refuse a name that is taken: each of them does what is asked of that name, and the answer "
            "that comes first is taken.",
            "Give each node a name of its own, or make only one of them.",
        )
    blamed = failed_by_error(recording, f"no node {name}", expected)
    if blamed is not None:
        return blamed
    if not found:
        return failed(
            f"no node {name}, and no other one",
            expected,
            "The program never comes to the line that makes a node.",
            "Call rclpy.init(), then make the node.",
        )
    seen = listing(sorted(found))
    because = _why_not_there(found, name, beside)
    return failed(f"no node {name}; there is {seen}", expected, because, how or _how(name))


def _why_not_there(found: Mapping[str, NodeSeen], wanted: str, beside: Collection[str]) -> str:
    twins = next((name for name in beside if name in found and found[name].most > 1), None)
    if twins is not None:
        return f"It was given the name of another one: {found[twins].most} nodes are called {twins}."
    others = sorted(found.keys() - set(beside))
    return _why_other_node(wanted, others) if others else "It was never made, or nobody keeps it."


def _why_other_node(wanted: str, seen: list[str]) -> str:
    base = wanted.rsplit("/", 1)[1]
    for other in seen:
        namespace, _, name = other.rpartition("/")
        if other.lower() == wanted.lower():
            return "Names are case-sensitive."
        if name == base:
            return f"The name is right, but the node is in the namespace {namespace or '/'}."
    near = difflib.get_close_matches(wanted, seen, 1, 0.6)
    if near:
        return f"{near[0]} is close, but ROS matches names letter by letter."
    return "The node has another name, or was never made."


def _how(name: str) -> str:
    namespace, _, base = name.rpartition("/")
    where = f", namespace={namespace!r}" if namespace else ""
    return f"Give Node.__init__ the name {base!r}{where}."


def nodes_gone_at_end(recording: Recording) -> Verdict:
    """When the program has ended, none of its nodes is on the graph any more. Needs `watching(to_the_end=True)`."""
    expected = "no node of the program on the graph once it has ended"
    watched = [node for node in recording.nodes if node.stayed is not None]
    if recording.nodes and not watched:
        raise ValueError("nodes_gone_at_end needs watching(to_the_end=True) in the criteria file")
    left = [node.name for node in watched if node.stayed]
    if not left:
        return passed(f"{count(len(watched), 'node')} gone from the graph")
    return failed(
        f"{listing(left)} still on the graph after the program had ended",
        expected,
        "The program was cut off (os._exit, a kill, an abort), so it could not say good-bye. Others see such a ghost "
        "for up to 20 s.",
        "Let main() come to its end: catch KeyboardInterrupt around the spin, then rclpy.try_shutdown().",
    )
