"""How the tests are spread over workers: a file stays together, long ones begin first, lessons go side by side."""

from pathlib import PurePath

import pytest

# Long waits first, so that no worker is left alone with one of them at the end.
LONG_FIRST = (
    "test_proofs",
    "test_browser_lessons",
    "test_notebooks_run",
    "test_browser_exercise",
    "test_nodes_with_timers",
)
BROWSERS = 2


def _rank(item: pytest.Item) -> int:
    stem = PurePath(item.path).stem
    return LONG_FIRST.index(stem) if stem in LONG_FIRST else len(LONG_FIRST)


def _group(item: pytest.Item, number: int) -> str:
    """Tests of a group run one after another in one worker. `number`: place of the test in its file."""
    stem = PurePath(item.path).stem
    if stem == "test_notebooks_run":
        return item.name
    if stem == "test_browser_lessons":
        return f"{stem}-{number % BROWSERS}"  # each has a JupyterLab and a Chromium of its own
    return str(item.path)


@pytest.hookimpl(tryfirst=True)  # before xdist looks for groups
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    numbers: dict[PurePath, int] = {}
    for item in items:
        number = numbers[item.path] = numbers.get(item.path, -1) + 1
        item.add_marker(pytest.mark.xdist_group(_group(item, number)))
    items.sort(key=_rank)
