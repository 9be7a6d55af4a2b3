"""Judges the nodes of a program on the graph."""

import difflib
from collections.abc import Collection, Mapping

from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.vocabulary.known_errors import failed_by_error
from workbook.criteria.vocabulary.phrasing import count, listing
from workbook.recording.recording import NodeSeen, Recording


def on_the_graph(
    recording: Recording, name: str, *, beside: Collection[str] = (), how: str | None = None
) -> Verdict:
    """A node of the fully qualified name `name`, such as "/robot/left_camera", is on the graph, once.

    `beside`: other nodes that a right program has, so that none of them is taken for a misspelled `name`. `how`: what
    to do when it has another name.
    """
    expected = f"one node {name}"
    found = {node.name: node for node in recording.nodes}
    if name in found and found[name].most == 1:
        return passed(f"{name} is on the graph")
    if name in found:
        return failed(
            "on-the-graph.twice",
            f"{found[name].most} nodes are called {name}",
            expected,
            "ROS allows duplicate node names. Every node with that name responds to a request, and the caller "
            "receives the first response.",
            "Give each node its own name, or create only one of them.",
        )
    blamed = failed_by_error(recording, f"no node {name}", expected)
    if blamed is not None:
        return blamed
    if not found:
        return failed(
            "on-the-graph.no-node",
            f"no node {name}, nor any other node",
            expected,
            "The program never reaches the line that creates a node.",
            "Call rclpy.init(), then create the node.",
        )
    return _not_there(found, name, beside, how or _how(name))


def _not_there(found: Mapping[str, NodeSeen], wanted: str, beside: Collection[str], try_this: str) -> Verdict:
    def fail(cause: str, because: str) -> Verdict:
        saw = f"no node {wanted}, only {listing(sorted(found))}"
        return failed(cause, saw, f"one node {wanted}", because, try_this)

    duplicate = next((name for name in beside if name in found and found[name].most > 1), None)
    if duplicate is not None:
        return fail(
            "on-the-graph.name-of-another",
            f"It has the name of another node: {found[duplicate].most} nodes are called {duplicate}.",
        )
    others = sorted(found.keys() - set(beside))
    if not others:
        return fail("on-the-graph.never-made", "It was never created, or the program doesn't store it.")
    base = wanted.rsplit("/", 1)[1]
    for other in others:
        namespace, _, name = other.rpartition("/")
        if other.lower() == wanted.lower():
            return fail("on-the-graph.other-case", "Names are case-sensitive.")
        if other.replace("/", "_") == wanted.replace("/", "_"):
            return fail(
                "on-the-graph.slash-for-underscore",
                f"The part before the last slash, {namespace or '/'}, is the namespace. The node is called {name}.",
            )
        if namespace == wanted:
            return fail(
                "on-the-graph.name-as-namespace",
                f"{base} is part of the namespace of {other}. The node itself is still called {name}.",
            )
        if name == base:
            return fail(
                "on-the-graph.other-namespace",
                f"The name is right, but the node is in the namespace {namespace or '/'}.",
            )
    near = difflib.get_close_matches(wanted, others, 1, 0.6)
    if near:
        return fail(
            "on-the-graph.misspelled", f"{near[0]} is close, but ROS compares names letter by letter."
        )
    return fail("on-the-graph.other-name", "The node has another name, or was never created.")


def _how(name: str) -> str:
    namespace, _, base = name.rpartition("/")
    where = f", namespace={namespace!r}" if namespace else ""
    return f"Give Node.__init__ the name {base!r}{where}."


def nodes_gone_at_end(recording: Recording) -> Verdict:
    """When the program has ended, none of its nodes is on the graph any more.

    Needs `watching(to_the_end=True)`; raises ValueError when the recording does not hold the end.
    """
    watched = [node for node in recording.nodes if node.stayed is not None]
    if recording.nodes and not watched:
        raise ValueError("nodes_gone_at_end needs watching(to_the_end=True) in the criteria file")
    left = [node.name for node in watched if node.stayed]
    if not left:
        return passed(f"{count(len(watched), 'node')} gone from the graph")
    return failed(
        "nodes-gone-at-end.cut-off",
        f"{listing(left)} still on the graph after the program had ended",
        "none of the program's nodes on the graph once it has ended",
        "The program ended abruptly (os._exit, a kill, an abort), so its node was never removed. Other programs "
        "still see the node for up to 20 s.",
        "Let main() return: catch KeyboardInterrupt around the spin, then call rclpy.try_shutdown().",
    )
