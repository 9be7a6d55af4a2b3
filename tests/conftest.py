"""How the tests are spread over workers, and what tests of several folders need.

A file stays together, long ones begin first, lessons go side by side. There are more workers than processors, because
most tests wait most of the time. The proofs of the exercises come first, with nothing beside them: what is judged on
the wall clock is judged once where nothing disturbs it. In the whole run, those on robot time keep all processors busy
by themselves; the few of `make test` go side by side with the other tests.
"""

import gc
import os
import re
import shutil
import tempfile
import time
from collections.abc import Iterator, Sequence
from pathlib import Path, PurePath
from typing import Any

import pytest
from hypothesis import HealthCheck, settings

from tests.exercises.tried_again import lines_of
from workbook.exercise.definition import load_exercise
from workbook.exercise.source import stems
from workbook.grading.slots.pool import warm_slots
from workbook.programs.fork_client import own_server

PROOFS = "test_proofs"
BROWSER_LESSONS = "test_browser_lessons"
ROOT = Path(__file__).resolve().parents[1]
LONG_FIRST = (
    PROOFS,
    BROWSER_LESSONS,
    "test_hostile",
    "test_notebooks_run",
    "test_browser_exercise",
    "test_tiers",
    "test_farm",
    "test_lessons_with_the_panel",
    "test_templates",
    "test_nodes_with_timers",
    "test_killed_grader",
    "test_fresh_machine",
    "test_watch",
    "test_nodes_of_12",
    "test_talking",
)
"""Files of more than half a minute, so that no worker is left alone with one of them at the end."""
ON_THE_WALL_CLOCK = {
    stem[:2] for stem in stems(ROOT / "solutions") if load_exercise(stem, ROOT).source.clock == "wall"
}
"""Exercises whose proofs go before those of the others."""
OVER = "proofs_over"
"""The worker that has run the proofs that come alone leaves this file for the others."""
LOOK_EVERY_S = 0.5
LONGEST_PROOFS_S = 45 * 60.0
"""Then the other tests begin, in case the worker with the proofs has died at its last test."""
BROWSERS = 2
"""How many JupyterLabs, each with a Chromium, share the lessons. What else needs a browser has one of its own."""


os.environ.pop("COLUMNS", None)  # workers have one, and what is printed there would be broken to fit it

# Property tests: the same examples in every run, and no deadline that a busy machine could miss.
settings.register_profile(
    "workbook", deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("workbook")
own_server.keep()  # a worker starts hundreds of programs
gc.disable()  # until all tests are there: to collect garbage among them would take a tenth of the time


@pytest.fixture(autouse=True)
def no_spare_slot() -> Iterator[None]:
    """No test judges in a slot that another one has left: what it changes of slots would have no effect."""
    warm_slots.close()  # a fixture of the file may have left one
    yield
    warm_slots.close()


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


def is_on_the_wall_clock(nodeid: str) -> bool:
    """Whether a test looks at an answer that is judged on the wall clock."""
    number = re.search(r"\[(\d\d)_", nodeid)
    return (
        PurePath(nodeid.partition("::")[0]).stem == PROOFS and bool(number) and number[1] in ON_THE_WALL_CLOCK
    )


def group_of(nodeid: str) -> str:
    """Tests of a group run one after another in one worker. Usually that is a file."""
    file, _, rest = nodeid.partition("::")
    stem = PurePath(file).stem
    if stem == "test_notebooks_run":
        return nodeid
    if stem.startswith("test_browser_"):
        number = re.search(r"\[(\d\d)_", rest) if stem == BROWSER_LESSONS else None
        return f"lessons in browser {int(number[1]) % BROWSERS}" if number else "browser"
    return file


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    def rank(item: pytest.Item) -> int:
        stem = item.path.stem
        if is_on_the_wall_clock(item.nodeid):
            return -1
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


# --- proofs first ---------------------------------------------------------------------------------------------


@pytest.hookimpl(optionalhook=True)
def pytest_configure_node(node: Any) -> None:
    """For each worker: where they meet."""
    config = node.config
    if not hasattr(config, OVER):
        setattr(config, OVER, Path(tempfile.mkdtemp(prefix="workbook-tests-")) / OVER)
    node.workerinput[OVER] = str(getattr(config, OVER))


def pytest_unconfigure(config: pytest.Config) -> None:
    if hasattr(config, OVER):
        shutil.rmtree(getattr(config, OVER).parent, ignore_errors=True)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item, nextitem: pytest.Item | None) -> Iterator[None]:
    """In a worker: no test begins before the last proof has ended."""
    told = getattr(item.config, "workerinput", {}).get(OVER)
    if told is None:
        return (yield)
    if not is_proof(item):
        _await_proofs(Path(told), item.session.items)
    try:
        return (yield)
    finally:
        if comes_alone(item) and (nextitem is None or not comes_alone(nextitem)):
            Path(told).touch()


def is_proof(item: pytest.Item) -> bool:
    """Whether a test belongs to the proofs of the exercises."""
    return item.path.stem == PROOFS


def comes_alone(item: pytest.Item) -> bool:
    """Whether all other tests wait for this one: for every proof in the whole run, for those in real time otherwise."""
    is_whole = item.config.getoption("markexpr") != "not whole"
    return is_proof(item) and (is_whole or is_on_the_wall_clock(item.nodeid))


def _await_proofs(over: Path, items: Sequence[pytest.Item]) -> None:
    deadline = time.monotonic() + LONGEST_PROOFS_S
    if any(map(comes_alone, items)):
        while not over.exists() and time.monotonic() < deadline:
            time.sleep(LOOK_EVERY_S)


# --- what the summary says ------------------------------------------------------------------------------------


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Tell how many proofs needed more than one try, by exercise."""
    told = lines_of(report for reports in terminalreporter.stats.values() for report in reports)
    if told:
        terminalreporter.section("answers that needed more than one try")
        terminalreporter.write("".join(f"{line}\n" for line in told))
