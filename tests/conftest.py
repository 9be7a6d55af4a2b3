"""How the tests are spread over workers: a file stays together, long ones begin first, lessons go side by side."""

import re
from pathlib import PurePath
from typing import Any

import pytest

# Long waits first, so that no worker is left alone with one of them at the end.
LONG_FIRST = (
    "test_proofs",
    "test_browser_lessons",
    "test_notebooks_run",
    "test_browser_exercise",
    "test_hostile",
    "test_farm",
    "test_tiers",
    "test_killed_grader",
    "test_nodes_with_timers",
)
BROWSERS = 2
"""How many JupyterLabs, each with a Chromium, share the lessons."""


def group_of(nodeid: str) -> str:
    """Tests of a group run one after another in one worker. Usually that is a file."""
    file, _, rest = nodeid.partition("::")
    stem = PurePath(file).stem
    if stem == "test_notebooks_run":
        return nodeid
    if stem == "test_browser_lessons":
        number = re.search(r"\[(\d\d)_", rest)
        return f"{file}-{int(number[1]) % BROWSERS if number else 0}"
    return file


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    def rank(item: pytest.Item) -> int:
        stem = PurePath(item.path).stem
        return LONG_FIRST.index(stem) if stem in LONG_FIRST else len(LONG_FIRST)

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
