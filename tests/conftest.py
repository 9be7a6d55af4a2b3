"""How the tests are spread over workers, and what tests of several folders need.

A file stays together, long ones begin first, lessons go side by side.
"""

import gc
import re
import tempfile
from collections.abc import Iterator
from pathlib import Path, PurePath
from typing import Any

import pytest

from workbook.grading.pool import spare
from workbook.observing.warm_start import own_server

LESSONS = "test_notebooks_run"
# Long ones first, so that no worker is left alone with one of them at the end.
LONG_FIRST = (
    "test_proofs",
    "test_browser_lessons",
    LESSONS,
    "test_browser_exercise",
    "test_nodes_with_timers",
)
# Lessons wait most of the time, these keep a processor busy: they begin after the lesson of this number, when the
# browsers, which are busy, too, are through most of theirs.
BETWEEN_LESSONS = {"test_hostile": 5, "test_farm": 8, "test_tiers": 10, "test_killed_grader": 12}
BROWSERS = 2
"""How many JupyterLabs, each with a Chromium, share the lessons. What else needs a browser goes to the first."""


own_server.keep()  # a worker starts hundreds of programs
gc.disable()  # until all tests are there: to collect garbage among them would take a tenth of the time


@pytest.fixture(autouse=True)
def no_spare_slot() -> Iterator[None]:
    """No test judges in a slot that another one has left: what it changes of slots would have no effect."""
    spare.close()  # a fixture of the file may have left one
    yield
    spare.close()


@pytest.fixture
def temporary(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder in which this process and those that it starts put their temporary files."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setenv("TMPDIR", str(folder))
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    return folder


def pytest_collection_finish() -> None:
    """What is there now stays: nobody needs to look through it for garbage again."""
    gc.freeze()
    gc.enable()


def group_of(nodeid: str) -> str:
    """Tests of a group run one after another in one worker. Usually that is a file."""
    file, _, rest = nodeid.partition("::")
    stem = PurePath(file).stem
    if stem == LESSONS:
        return nodeid
    if stem.startswith("test_browser_"):
        number = re.search(r"\[(\d\d)_", rest) if stem == "test_browser_lessons" else None
        return f"browser {int(number[1]) % BROWSERS if number else 0}"
    return file


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    def rank(item: pytest.Item) -> tuple[int, float]:
        stem = item.path.stem
        if stem in BETWEEN_LESSONS:
            return LONG_FIRST.index(LESSONS), BETWEEN_LESSONS[stem] + 0.5
        if stem not in LONG_FIRST:
            return len(LONG_FIRST), 0
        number = re.search(r"\[(\d\d)\]", item.nodeid) if stem == LESSONS else None
        return LONG_FIRST.index(stem), int(number[1]) if number else 0

    items.sort(key=rank)


@pytest.hookimpl(optionalhook=True)  # only with pytest-xdist
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """Spread by group in the order of collection. (xdist's own groups have no effect under this pytest.)"""
    from xdist.scheduler import LoadScopeScheduling

    class ByGroup(LoadScopeScheduling):
        def _split_scope(self, nodeid: str) -> str:
            return group_of(nodeid)

    config.option.loadscopereorder = False
    return ByGroup(config, log)
