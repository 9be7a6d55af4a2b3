"""Draw the current graph of nodes and the topics over which they exchange messages."""

from workbook.pictures import graph as drawing
from workbook.pictures.stills import Still
from workbook.ros.tools import graph


def graph_picture(*highlight: str) -> Still:
    """Draw the ROS graph on this notebook's domain: nodes, topics, and an arrow for each publisher and subscription.

    `highlight`: the names of nodes or topics to draw with a bold frame.
    """
    seen = graph()
    arrows = [
        (edge.node, edge.topic) if edge.role == "publishes" else (edge.topic, edge.node)
        for edge in seen.edges
    ]
    topics = {name: ", ".join(types) for name, types in seen.topics.items()}
    picture = drawing.draw(seen.nodes, topics, arrows, highlight=highlight)
    return Still(picture, drawing.describe(seen.nodes, topics, arrows))
