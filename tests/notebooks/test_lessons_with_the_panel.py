"""With the panel open, a lesson still shows the committed outputs, because the panel is invisible in the ROS graph."""

import os
import threading

import psutil
import pytest

from tests.notebooks.test_notebooks_run import TREE
from tests.ros.panel_watcher import Watcher
from workbook.authoring.comparing import compare
from workbook.ros.notebook_registry import open_notebooks

LOOK_EVERY_S = 0.2


class Follower(threading.Thread):
    """Makes an observer follow each kernel that this process starts, as the panel follows the notebook in front."""

    def __init__(self, watcher: Watcher) -> None:
        super().__init__()
        self.watcher = watcher
        self.over = threading.Event()

    def run(self) -> None:
        watched: int | None = None
        while not self.over.wait(LOOK_EVERY_S):
            below = {one.pid for one in psutil.Process(os.getpid()).children(recursive=True)}
            domains = [one.domain_id for one in open_notebooks() if one.pid in below]
            domain = domains[0] if domains else None
            if domain != watched:
                watched = domain
                self.watcher.order(domain=domain)


@pytest.mark.slow
@pytest.mark.whole
@pytest.mark.parametrize("stem", ["02_nodes", "13_qos_and_discovery"])
def test_a_lesson_shows_what_is_committed(stem: str, capfd: pytest.CaptureFixture[str]) -> None:
    watcher = Watcher()
    follower = Follower(watcher)
    follower.start()
    try:
        failed = compare(TREE, [stem])
    finally:
        follower.over.set()
        follower.join()
        watcher.close()
    seen = [one for one in watcher.told if one["kind"] == "graph" and one["topics"]]
    heard = [one for one in watcher.told if one["kind"] == "news" and one["topics"]]
    assert seen and heard, "the panel saw nothing of this lesson"
    assert not failed, capfd.readouterr().out
