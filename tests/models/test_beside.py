"""A model in a process next to a node: it loads once, returns the detector's results, and can die without the node."""

import os
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context

import numpy as np
import pytest

from workbook.models import DeskDetector, beside
from workbook.models.accuracy import held_back


@pytest.fixture
def pool() -> Iterator[ProcessPoolExecutor]:
    with ProcessPoolExecutor(1, mp_context=get_context("spawn"), initializer=beside.load) as made:
        yield made


def test_a_process_sees_what_the_detector_sees(pool: ProcessPoolExecutor) -> None:
    picture = held_back(1)
    assert DeskDetector()(picture)
    assert pool.submit(beside.look, picture).result() == DeskDetector()(picture)
    assert pool.submit(beside.size, picture).result() == picture.nbytes


def test_a_crash_of_the_process_is_an_exception_here(pool: ProcessPoolExecutor) -> None:
    with pytest.raises(BrokenProcessPool):
        pool.submit(os._exit, 3).result()


def test_without_loading_the_detector_is_loaded_at_the_first_picture(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(beside, "_loaded", [])
    assert beside.look(np.zeros((120, 160, 3), np.uint8)) == []
    assert len(beside._loaded) == 1
