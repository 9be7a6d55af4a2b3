import numpy as np
import pytest

from tests.pictures.reading import colored, drawn
from workbook.pictures import graph, palette, png

TOPICS = {"/robot/status": "std_msgs/msg/String", "/robot/battery": "std_msgs/msg/Float32"}
EDGES = [("/publisher", "/robot/status"), ("/publisher", "/robot/battery"), ("/robot/status", "/dashboard")]


def boxes(picture: bytes, color: str) -> int:
    """Return how many outlines of a color there are, by the runs in its densest column."""
    columns = colored(picture, color)
    return max(int(np.count_nonzero(np.diff(column.astype(int)) == 1)) for column in columns[:-50].T)


def test_nodes_are_blue_and_topics_are_green() -> None:
    picture = graph.draw(["/publisher", "/dashboard"], TOPICS, EDGES)
    blue, green = (
        np.nonzero(colored(picture, color)[:-60].any(axis=0))[0] for color in (palette.BLUE, palette.GREEN)
    )
    assert blue.min() < green.min() < green.max() < blue.max(), (
        "publisher, topics, subscriber from left to right"
    )


def test_an_arrow_joins_what_an_edge_joins() -> None:
    joined = graph.draw(["/a"], ["/b"], [("/a", "/b")])
    apart = graph.draw(["/a"], ["/b"], [])
    middle = np.nonzero(colored(joined, palette.BLUE)[:-60].any(axis=0))[0].max() + 40
    assert drawn(joined)[:-60, middle].any()
    assert png.size(apart) != png.size(joined) or not drawn(apart)[:-60, middle].any()


def test_a_circle_is_drawn_with_an_arrow_that_comes_back() -> None:
    line = graph.draw(["/talker"], ["/chatter"], [("/talker", "/chatter")])
    circle = graph.draw(["/talker"], ["/chatter"], [("/talker", "/chatter"), ("/chatter", "/talker")])
    assert png.size(circle)[1] > png.size(line)[1]


def test_long_circles_and_many_nodes_end() -> None:
    nodes, topics = [f"/node_{i}" for i in range(12)], [f"/topic_{i}" for i in range(12)]
    edges = [(f"/node_{i}", f"/topic_{i}") for i in range(12)]
    edges += [(f"/topic_{i}", f"/node_{(i + 1) % 12}") for i in range(12)]
    width, height = png.size_on_screen(graph.draw(nodes, topics, edges))
    assert width > 2000
    assert height < 200


def test_a_topic_nobody_reads_and_a_node_alone_are_drawn() -> None:
    picture = graph.draw(["/publisher", "/lonely"], TOPICS, EDGES[:2])
    assert boxes(picture, palette.GREEN) >= 4  # two boxes, each with an upper and a lower line
    assert boxes(picture, palette.BLUE) >= 4


def test_an_empty_graph_says_so() -> None:
    assert np.count_nonzero(drawn(graph.draw([], [], []))) > 300


def test_an_edge_to_nowhere_is_named() -> None:
    with pytest.raises(ValueError, match="/publisher → /robot/legs"):
        graph.draw(["/publisher"], TOPICS, [("/publisher", "/robot/legs")])
    with pytest.raises(ValueError, match="one of the nodes and one of the topics"):
        graph.draw(["/a", "/b"], [], [("/a", "/b")])


def test_the_highlighted_node_stands_out() -> None:
    plain = graph.draw(["/publisher", "/dashboard"], TOPICS, EDGES)
    strong = graph.draw(["/publisher", "/dashboard"], TOPICS, EDGES, highlight=["/publisher"])
    assert (
        np.count_nonzero(colored(strong, palette.BLUE)) > np.count_nonzero(colored(plain, palette.BLUE)) + 200
    )


def test_the_description_is_stable() -> None:
    one = graph.describe(["/b", "/a"], TOPICS, EDGES)
    assert one == graph.describe(["/a", "/b"], dict(reversed(TOPICS.items())), EDGES[::-1])
    assert one.startswith("ROS graph: nodes /a, /b; topics /robot/battery, /robot/status; /publisher to ")
