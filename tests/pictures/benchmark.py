"""Compare the CPU time of a figure with an empty matplotlib figure: `python -m tests.pictures.benchmark`."""

import io
import time
from collections.abc import Callable
from statistics import median

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from workbook.pictures import dashboard, graph, humanoid, marks, timeline
from workbook.pictures.joints import walking


def empty_figure() -> bytes:
    """Draw the reference: matplotlib's axes without content, in the humanoid's size."""
    figure = Figure(figsize=(4.2, 4.2))
    FigureCanvasAgg(figure)
    figure.subplots()
    file = io.BytesIO()
    figure.savefig(file, format="png", dpi=100 * humanoid.SCALE, transparent=True)
    return file.getvalue()


def cost(draw: Callable[[int], object], rounds: int = 15) -> list[float]:
    """Return the CPU time of each round (s), after a warm-up round."""
    draw(0)
    times = []
    for index in range(rounds):
        start = time.process_time()
        draw(index)
        times.append(time.process_time() - start)
    return times


TOPICS = {"/robot/status": [i * 1.0 for i in range(10)], "/robot/battery": [i * 2.0 for i in range(5)]}
EDGES = [("/robot", "/robot/status"), ("/robot", "/robot/battery"), ("/robot/status", "/dashboard")]
PICTURES: dict[str, Callable[[int], object]] = {
    "empty matplotlib figure": lambda index: empty_figure(),
    "humanoid": lambda index: humanoid.draw(walking(index / 20), lamp="operational"),
    "humanoid with panel": lambda index: humanoid.draw(walking(index / 20), panel=True),
    "dashboard": lambda index: dashboard.draw("operational", 100 - index, TOPICS, now=10 + index / 20),
    "timeline": lambda index: timeline.strip(TOPICS, periods={"/robot/status": 1.0}, end=10 + index),
    "tiny timeline": lambda index: marks.tiny([1, 2, 3], end=5 + index, period=1),
    "graph": lambda index: graph.draw(["/robot", "/dashboard"], list(TOPICS), EDGES),
}


def main() -> None:
    yardstick = 0.0
    print(f"{'picture':26}{'ms':>7}{'spread':>16}{'× yardstick':>13}")
    for name, draw in PICTURES.items():
        times = sorted(1000 * part for part in cost(draw))
        middle = median(times)
        yardstick = yardstick or middle
        print(f"{name:26}{middle:7.1f}{times[0]:8.1f} –{times[-1]:6.1f}{middle / yardstick:13.2f}")


if __name__ == "__main__":
    main()
