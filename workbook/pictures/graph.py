"""Draw a ROS graph: nodes and topics as boxes, and an arrow for each publisher and subscription."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from workbook.pictures.canvas import Canvas, Font, Paint, Point, shorten, text_width
from workbook.pictures.palette import BLUE, GREEN, GREY

Edge = tuple[str, str]

_MOST, _GAP_X, _GAP_Y, _MARGIN = 230.0, 74.0, 22.0, 16.0
_NODE_HEIGHT, _TOPIC_HEIGHT = 38.0, 46.0


@dataclass(eq=False)
class _Box:
    name: str
    lines: list[str]
    is_node: bool
    layer: int = 0
    x: float = 0.0
    y: float = 0.0
    width: float = 0.0
    height: float = 0.0
    before: list["_Box"] = field(default_factory=list)
    after: list["_Box"] = field(default_factory=list)

    @property
    def middle(self) -> float:
        return self.y + self.height / 2


def draw(
    nodes: Iterable[str],
    topics: Mapping[str, str] | Iterable[str],
    edges: Iterable[Edge],
    *,
    highlight: Iterable[str] = (),
) -> bytes:
    """Return the graph as PNG bytes.

    `nodes` are fully qualified names, and `topics` maps names to message types (or just lists names). Each edge goes
    from a node to a topic that it publishes, or from a topic to a node that subscribes to it. Names in `highlight` are
    drawn with a thicker outline. Raises ValueError for an edge that doesn't join a known node and a known topic.
    """
    node_boxes = {name: _node(name) for name in dict.fromkeys(nodes)}
    types = dict(topics) if isinstance(topics, Mapping) else dict.fromkeys(topics, "")
    topic_boxes = {name: _topic(name, kind) for name, kind in types.items()}
    pairs = []
    for start, end in dict.fromkeys(edges):
        if start in node_boxes and end in topic_boxes:
            pairs.append((node_boxes[start], topic_boxes[end]))
        elif start in topic_boxes and end in node_boxes:
            pairs.append((topic_boxes[start], node_boxes[end]))
        else:
            raise ValueError(f"the edge {start} → {end} must join one of the nodes and one of the topics")
    boxes = [*node_boxes.values(), *topic_boxes.values()]
    if not boxes:
        canvas = Canvas(300, 48)
        canvas.text((150, 29), "no nodes and no topics", Font(size=13), align="center")
        return canvas.png()
    forward, backward = _directed(boxes, pairs)
    width, height = _place(boxes, forward)
    canvas = Canvas(max(width, 330), height + 34 + (30 if backward else 0))
    for source, target in forward:
        _arrow(canvas, source, target)
    for source, target in backward:
        _arrow_back(canvas, source, target, height)
    bold = set(highlight)
    for box in boxes:
        _paint(canvas, box, strong=box.name in bold)
    _legend(canvas, canvas.height - 12)
    return canvas.png()


def describe(nodes: Iterable[str], topics: Mapping[str, str] | Iterable[str], edges: Iterable[Edge]) -> str:
    """Describe the graph in words, as its alternative text."""
    links = sorted(f"{start} to {end}" for start, end in edges)
    return f"ROS graph: nodes {_list(nodes)}; topics {_list(topics)}; {', '.join(links) or 'no connections'}"


def _list(names: Iterable[str]) -> str:
    return ", ".join(sorted(names)) or "none"


def _node(name: str) -> _Box:
    words = shorten(name, _MOST, 13, bold=True)
    return _Box(name, [words], True, width=text_width(words, 13, bold=True) + 34, height=_NODE_HEIGHT)


def _topic(name: str, kind: str) -> _Box:
    lines = [shorten(name, _MOST, 13)]
    if kind:
        lines.append(shorten(kind, _MOST, 11))
    width = max(text_width(lines[0], 13), text_width(lines[-1], 11)) + 22
    return _Box(name, lines, False, width=width, height=_TOPIC_HEIGHT if kind else 32.0)


_Pairs = list[tuple[_Box, _Box]]


def _directed(boxes: list[_Box], pairs: _Pairs) -> tuple[_Pairs, _Pairs]:
    """Return the arrows that go forward, and those that would close a cycle."""
    leaving: dict[_Box, _Pairs] = {box: [] for box in boxes}
    entered = {end for _, end in pairs}
    for pair in pairs:
        leaving[pair[0]].append(pair)
    state: dict[_Box, str] = {}
    forward: _Pairs = []
    backward: _Pairs = []

    def visit(box: _Box) -> None:
        state[box] = "open"
        for pair in leaving[box]:
            if state.get(pair[1]) == "open":
                backward.append(pair)
                continue
            forward.append(pair)
            if pair[1] not in state:
                visit(pair[1])
        state[box] = "done"

    for box in sorted(boxes, key=lambda box: (box in entered, not box.is_node)):
        if box not in state:
            visit(box)
    return forward, backward


def _place(boxes: list[_Box], forward: _Pairs) -> tuple[float, float]:
    """Arrange the boxes in layers from left to right, sorted by their neighbors' positions. Return the total size."""
    for start, end in forward:
        start.after.append(end)
        end.before.append(start)

    def deepen(box: _Box, layer: int) -> None:
        if layer > box.layer:
            box.layer = layer
        for after in box.after:
            if after.layer <= box.layer:
                deepen(after, box.layer + 1)

    for box in boxes:
        if not box.before:
            deepen(box, 0 if box.is_node or not box.after else 1)
    layers: list[list[_Box]] = [[] for _ in range(max(box.layer for box in boxes) + 1)]
    for box in boxes:
        layers[box.layer].append(box)
    heights = [sum(box.height for box in layer) + _GAP_Y * (len(layer) - 1) for layer in layers]
    tallest = max(heights)
    x = _MARGIN
    for layer, height in zip(layers, heights, strict=True):
        wide = max((box.width for box in layer), default=0.0)
        y = _MARGIN + (tallest - height) / 2
        for box in layer:
            box.x, box.y = x + (wide - box.width) / 2, y
            y += box.height + _GAP_Y
        x += wide + _GAP_X
    for _ in range(4):
        for layer, height in zip(layers, heights, strict=True):
            layer.sort(key=_wish)
            y = _MARGIN + (tallest - height) / 2
            for box in layer:
                box.y = y
                y += box.height + _GAP_Y
    return x - _GAP_X + _MARGIN, tallest + 2 * _MARGIN


def _wish(box: _Box) -> float:
    near = [*box.before, *box.after]
    return sum(other.middle for other in near) / len(near) if near else math.inf


def _arrow(canvas: Canvas, start: _Box, end: _Box) -> None:
    a, b = (start.x + start.width, start.middle), (end.x - 3, end.middle)
    pull = max(24.0, (b[0] - a[0]) * 0.45)
    canvas.curve(a, (a[0] + pull, a[1]), (b[0] - pull, b[1]), (b[0] - 7, b[1]), Paint(width=2))
    _head(canvas, b, 1)


def _arrow_back(canvas: Canvas, start: _Box, end: _Box, bottom: float) -> None:
    a = (start.x + start.width * 0.5, start.y + start.height)
    b = (end.x + end.width * 0.5, end.y + end.height + 3)
    low = max(bottom + 8, a[1] + 26, b[1] + 26)
    canvas.curve(a, (a[0], low + 8), (b[0], low + 8), (b[0], b[1] + 7), Paint(width=2))
    _head(canvas, b, 0)


def _head(canvas: Canvas, tip: Point, right: int) -> None:
    x, y = tip
    sides = [(x - 10, y - 5.5), (x - 10, y + 5.5)] if right else [(x - 5.5, y + 10), (x + 5.5, y + 10)]
    canvas.polygon([tip, *sides], Paint(fill=GREY, stroke=GREY, width=1))


def _paint(canvas: Canvas, box: _Box, *, strong: bool) -> None:
    color = BLUE if box.is_node else GREEN
    radius = box.height / 2 if box.is_node else 6.0
    canvas.box((box.x, box.y), (box.width, box.height), Paint(fill=color, alpha=0.08), radius=radius)
    canvas.box(
        (box.x, box.y),
        (box.width, box.height),
        Paint(stroke=color, width=3.6 if strong else 2.0),
        radius=radius,
    )
    middle = box.x + box.width / 2
    if len(box.lines) == 1:
        canvas.text(
            (middle, box.middle + 4.5),
            box.lines[0],
            Font(size=13, bold=box.is_node, color=color),
            align="center",
        )
    else:
        canvas.text((middle, box.middle - 3), box.lines[0], Font(size=13, color=color), align="center")
        canvas.text((middle, box.middle + 13), box.lines[1], Font(size=11), align="center")


def _legend(canvas: Canvas, y: float) -> None:
    x = _MARGIN
    canvas.box((x, y - 11), (26, 14), Paint(stroke=BLUE, width=1.8), radius=7)
    canvas.text((x + 33, y), "node", Font(size=11))
    canvas.box((x + 76, y - 11), (26, 14), Paint(stroke=GREEN, width=1.8), radius=3)
    canvas.text((x + 109, y), "topic", Font(size=11))
    canvas.line([(x + 154, y - 4), (x + 172, y - 4)], Paint(width=2))
    _head(canvas, (x + 180, y - 4), 1)
    canvas.text((x + 187, y), "messages", Font(size=11))
