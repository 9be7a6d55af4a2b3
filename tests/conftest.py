"""Distribute the tests over workers, and provide fixtures that tests in several folders need.

The tests of a file stay together, long files begin first, and lessons run in parallel. There are more workers than
CPUs, because most tests wait most of the time.

The proofs of the exercises come first, while no other test runs: an undisturbed answer on the wall clock has to be
judged only once. In the whole run, the proofs on simulated time keep all CPUs busy by themselves. The few proofs of
`make test` on simulated time run next to the other tests.
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
"""Files that take more than half a minute. They begin first, so that no worker is left alone with one at the end."""
ON_THE_WALL_CLOCK = {
    stem[:2] for stem in stems(ROOT / "solutions") if load_exercise(stem, ROOT).source.clock == "wall"
}
"""Exercises judged on the wall clock. Their proofs go first."""
OVER = "proofs_over"
"""The worker that has run the last proof that comes alone creates this file for the other workers."""
LOOK_EVERY_S = 0.5
LONGEST_PROOFS_S = 45 * 60.0
"""After this time, the other tests begin anyway, in case the worker with the proofs died at its last test."""
BROWSERS = 2
"""How many JupyterLabs, each with a Chromium, share the lessons. All other browser tests share one more."""


os.environ.pop("COLUMNS", None)  # set in workers, where it would wrap what the tests print

# Property tests: the same examples in every run, and no deadline that a busy machine could miss.
settings.register_profile(
    "workbook", deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("workbook")
own_server.keep()  # a worker starts hundreds of programs
gc.disable()  # until all tests are collected: garbage collection during collection would take a tenth of the time


@pytest.fixture(autouse=True)
def no_spare_slot() -> Iterator[None]:
    """Keep tests from judging in a slot that another test left.

    Otherwise, a test's changes to slots would have no effect.
    """
    warm_slots.close()  # a fixture of the file may have left a slot
    yield
    warm_slots.close()


@pytest.fixture
def temporary(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Create an empty folder for the temporary files of this process and of all processes that it starts."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setenv("TMPDIR", str(folder))
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    return folder


def pytest_collection_finish() -> None:
    """Exclude all objects that exist now from garbage collection, because they live as long as the process."""
    gc.freeze()
    gc.enable()


def is_on_the_wall_clock(nodeid: str) -> bool:
    """Return whether a test is a proof of an answer that is judged on the wall clock."""
    number = re.search(r"\[(\d\d)_", nodeid)
    return (
        PurePath(nodeid.partition("::")[0]).stem == PROOFS and bool(number) and number[1] in ON_THE_WALL_CLOCK
    )


def group_of(nodeid: str) -> str:
    """Return a test's group, usually its file. Tests of a group run one after another in one worker."""
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
    """Distribute by group in the order of collection. (xdist's own groups have no effect under this pytest.)"""
    from xdist.scheduler import LoadScopeScheduling

    class ByGroup(LoadScopeScheduling):
        def _split_scope(self, nodeid: str) -> str:
            return group_of(nodeid)

    config.option.loadscopereorder = False
    return ByGroup(config, log)


# --- proofs first ---------------------------------------------------------------------------------------------


@pytest.hookimpl(optionalhook=True)
def pytest_configure_node(node: Any) -> None:
    """Give each worker the path of the file that tells it when the proofs are over."""
    config = node.config
    if not hasattr(config, OVER):
        setattr(config, OVER, Path(tempfile.mkdtemp(prefix="workbook-tests-")) / OVER)
    node.workerinput[OVER] = str(getattr(config, OVER))


def pytest_unconfigure(config: pytest.Config) -> None:
    if hasattr(config, OVER):
        shutil.rmtree(getattr(config, OVER).parent, ignore_errors=True)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item, nextitem: pytest.Item | None) -> Iterator[None]:
    """In a worker, start no other test before the last proof has ended."""
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
    """Return whether a test is one of the proofs of the exercises."""
    return item.path.stem == PROOFS


def comes_alone(item: pytest.Item) -> bool:
    """Return whether all other tests wait for this one.

    In the whole run, they wait for every proof, otherwise only for those on the wall clock.
    """
    is_whole = item.config.getoption("markexpr") != "not whole"
    return is_proof(item) and (is_whole or is_on_the_wall_clock(item.nodeid))


def _await_proofs(over: Path, items: Sequence[pytest.Item]) -> None:
    deadline = time.monotonic() + LONGEST_PROOFS_S
    if any(map(comes_alone, items)):
        while not over.exists() and time.monotonic() < deadline:
            time.sleep(LOOK_EVERY_S)


# --- what the summary says ------------------------------------------------------------------------------------


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Print for each exercise how many proofs needed more than one try."""
    told = lines_of(report for reports in terminalreporter.stats.values() for report in reports)
    if told:
        terminalreporter.section("answers that needed more than one try")
        terminalreporter.write("".join(f"{line}\n" for line in told))
