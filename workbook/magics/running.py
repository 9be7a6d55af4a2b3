"""The student's program while it runs beside the notebook, on the notebook's own domain."""

import atexit
import os
import time
from collections import Counter
from pathlib import Path

from workbook.observing.process import NodeProcess

SETTLE_S = 10.0


class Running:
    """At most one started program per exercise."""

    def __init__(self) -> None:
        self._programs: dict[str, NodeProcess] = {}
        atexit.register(self.stop_all)

    def start(self, stem: str, program: Path, driver: Path | None = None) -> NodeProcess:
        """Start `program`, ending an earlier run of the same exercise first."""
        self.stop(stem)
        process = NodeProcess(program, int(os.environ["ROS_DOMAIN_ID"]), driver=driver)
        self._programs[stem] = process
        return process

    def stop(self, stem: str) -> NodeProcess | None:
        """End the program of an exercise. Returns it, or None if it was not running."""
        process = self._programs.pop(stem, None)
        if process is None:
            return None
        was_running = process.is_running()
        process.stop()
        return process if was_running else None

    def stop_all(self) -> list[str]:
        return [stem for stem in list(self._programs) if self.stop(stem) is not None]

    def running(self) -> list[str]:
        return [stem for stem, process in self._programs.items() if process.is_running()]


def wait_for_nodes(process: NodeProcess, known: Counter[str]) -> list[str]:
    """Names of nodes that appeared on the graph since `known`, as soon as there is one. Twins count.

    Gives up when the program ends or after ten seconds. Nodes that this notebook has just made with `fresh` may come
    onto the graph meanwhile; they are not the program's.
    """
    own = own_names()
    deadline = time.monotonic() + SETTLE_S
    while time.monotonic() < deadline:
        now = node_names()
        new = sorted(now - (known | own))
        known = known & now  # one that has gone since is no longer known: its name may come again
        if new or not process.is_running():
            return new
        time.sleep(0.02)
    return []


def own_names() -> Counter[str]:
    """Full names of the nodes that this notebook made with `fresh`."""
    from rclpy.utilities import get_default_context

    from workbook.ros.twins import nodes_in

    return Counter(node.get_fully_qualified_name() for node in nodes_in(get_default_context()))


def node_names() -> Counter[str]:
    """Full names of all nodes on this notebook's domain, hidden ones left out."""
    from workbook.ros.standing import standing_node

    found = standing_node().get_node_names_and_namespaces()
    return Counter(f"{namespace.rstrip('/')}/{name}" for name, namespace in found if not name.startswith("_"))
