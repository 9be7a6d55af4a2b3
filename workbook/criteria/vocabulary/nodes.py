"""Judge which of a program's nodes are in the graph."""

import difflib
from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

from workbook.criteria.rules import Words, otherwise
from workbook.criteria.verdict import Verdict, passed
from workbook.criteria.vocabulary.known_errors import failed_by_error
from workbook.criteria.vocabulary.phrasing import count
from workbook.recording.recording import NodeSeen, Recording

WORDS = Words(__file__)


@dataclass(frozen=True)
class _Wanted:
    """A node that should be in the graph, and the nodes that were found there.

    `beside` and `how`: see `on_the_graph`. `other`: the found node whose name is compared with the wanted one.
    """

    wanted: str
    found: Mapping[str, NodeSeen]
    beside: Collection[str]
    how: str
    other: str = ""

    @property
    def most(self) -> int:
        return self.found[self.wanted].most

    @property
    def names(self) -> list[str]:
        return sorted(self.found)

    @property
    def duplicate(self) -> str | None:
        """The name of another required node that is in the graph more than once, or None if there is none."""
        return next((name for name in self.beside if name in self.found and self.found[name].most > 1), None)

    @property
    def duplicates(self) -> int:
        return self.found[self.duplicate or ""].most

    @cached_property
    def others(self) -> list[str]:
        return sorted(self.found.keys() - set(self.beside))

    @property
    def base(self) -> str:
        return self.wanted.rsplit("/", 1)[1]

    @property
    def namespace(self) -> str:
        return self.other.rpartition("/")[0] or "/"

    @property
    def name(self) -> str:
        return self.other.rpartition("/")[2]

    @property
    def near(self) -> list[str]:
        return difflib.get_close_matches(self.wanted, self.others, 1, 0.6)


_TWICE = WORDS.cause("on-the-graph.twice", _Wanted)
_BY_ERROR = WORDS.seen("on-the-graph.by-error", _Wanted)
_NOT_MADE = WORDS.rules(
    _Wanted,
    "on-the-graph",
    ("no-node", lambda node: not node.found),
    ("name-of-another", lambda node: node.duplicate is not None),
    ("never-made", lambda node: not node.others),
)
_LIKE_ANOTHER = WORDS.rules(
    _Wanted,
    "on-the-graph",
    ("other-case", lambda node: node.other.lower() == node.wanted.lower()),
    ("slash-for-underscore", lambda node: node.other.replace("/", "_") == node.wanted.replace("/", "_")),
    ("name-as-namespace", lambda node: node.namespace == node.wanted),
    ("other-namespace", lambda node: node.name == node.base),
)
_UNLIKE = WORDS.rules(
    _Wanted, "on-the-graph", ("misspelled", lambda node: node.near), ("other-name", otherwise)
)
_CUT_OFF = WORDS.cause("nodes-gone-at-end.cut-off", ("left",))


def on_the_graph(
    recording: Recording, name: str, *, beside: Collection[str] = (), how: str | None = None
) -> Verdict:
    """Check that the graph contains exactly one node named `name` (fully qualified, such as "/robot/left_camera").

    `beside`: the exercise's other nodes, which must not be mistaken for misspellings of `name`. `how`: advice for the
    student if the node has a different name.
    """
    found = {node.name: node for node in recording.nodes}
    node = _Wanted(name, found, beside, how or _how(name))
    if name in found:
        return passed(f"{name} is in the graph") if node.most == 1 else _TWICE.verdict(node)
    early = failed_by_error(recording, *_BY_ERROR(node)) or _NOT_MADE.first(node)
    alike = (_LIKE_ANOTHER.first(replace(node, other=other)) for other in node.others)
    return early or next((verdict for verdict in alike if verdict), None) or _UNLIKE.verdict(node)


def _how(name: str) -> str:
    namespace, _, base = name.rpartition("/")
    where = f", namespace={namespace!r}" if namespace else ""
    return f"Give Node.__init__ the name {base!r}{where}."


def nodes_gone_at_end(recording: Recording) -> Verdict:
    """Check that none of the program's nodes remains in the graph after the program exits.

    This check needs `watching(to_the_end=True)`. Raises ValueError if the recording doesn't include the exit.
    """
    watched = [node for node in recording.nodes if node.stayed is not None]
    if recording.nodes and not watched:
        raise ValueError("nodes_gone_at_end needs watching(to_the_end=True) in the criteria file")
    left = [node.name for node in watched if node.stayed]
    return (
        _CUT_OFF.verdict(left=left) if left else passed(f"{count(len(watched), 'node')} gone from the graph")
    )
