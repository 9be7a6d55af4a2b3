"""A pytest plugin that lets nbval see what JupyterLab shows.

nbval by itself drops updates of a display and piles up cleared outputs, so that a picture that moves never equals the
one committed. This plugin applies both as they come. Pictures inside HTML are not compared. Numbers marked as varying
(`≈ 23 ms`) count as equal, but a cell fails when one of them is outside of its range. The plugin also sets the
sanitize file unless another is given, compares only text in notebooks whose metadata says `workbook.compare: text`,
fails a cell whose magic does not exist, talks to kernels over Unix sockets, and runs each in an empty folder, so that
nothing is left in the checkout. It gives each notebook an answers folder of its own unless WORKBOOK_ANSWERS is set.
Nobody looks at what moves, and it is drawn twice a second only. With WORKBOOK_RAN it starts no kernel, and compares
what that notebook shows, which was run elsewhere.
"""

import gc
import json
import os
import shutil
import tempfile
from collections.abc import Callable, Generator
from pathlib import Path
from typing import Any

import nbformat
import nbval.kernel
import nbval.plugin
import pytest
from nbval.plugin import IPyNbCell, IPyNbFile, NbCellError

from workbook.authoring.kernels import PrivateKernelManager
from workbook.authoring.outputs import SANITIZE, texts, without_numbers, without_pictures
from workbook.authoring.replay import RAN, Replay
from workbook.lesson.measured import UNUSUAL
from workbook.lesson.predictions import UNATTENDED
from workbook.ros.scratch import sweep_scratch

OUTPUTS = ("display_data", "execute_result", "stream", "error")
NOT_TEXT = ("text/html", "text/markdown", "image/svg+xml")
NO_MAGIC = "UsageError:"
ANSWERS = "WORKBOOK_ANSWERS"
MOST_PICTURES = "WORKBOOK_PICTURES_PER_SECOND"
_own_folder = pytest.StashKey[Path]()


def pytest_configure(config: pytest.Config) -> None:
    """Run kernels on Unix sockets, set the sanitize file, and draw live pictures twice a second only."""
    nbval.kernel.KernelManager = KernelInAnEmptyFolder
    ran = os.environ.get(RAN)
    if ran:
        nbval.plugin.RunningKernel = lambda *_, **__: Replay(Path(ran))
    os.environ.setdefault(MOST_PICTURES, "2")
    gc.freeze()  # what is loaded stays; the messages of a kernel make the collector look through it again and again
    if getattr(config.option, "nbval_sanitize_with", SANITIZE) is None:
        config.option.nbval_sanitize_with = str(SANITIZE)


def pytest_unconfigure(config: pytest.Config) -> None:
    """Remove the answers folder of this run, and what killed kernels left in temporary folders."""
    folder = config.stash.get(_own_folder, None)
    if folder is not None:
        shutil.rmtree(folder, ignore_errors=True)
    sweep_scratch()  # nbval kills its kernels


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    """Give each notebook an answers folder of its own, unless WORKBOOK_ANSWERS is set. Nobody predicts."""
    if not isinstance(item, IPyNbCell):
        return
    os.environ[UNATTENDED] = "1"
    stash = item.config.stash
    if _own_folder not in stash:
        if ANSWERS in os.environ:
            return
        stash[_own_folder] = Path(tempfile.mkdtemp(prefix="answers-"))
    place = item.path.with_suffix("").relative_to(item.path.anchor)
    os.environ[ANSWERS] = str(stash[_own_folder] / "-".join(place.parts[-3:]))


def pytest_collectstart(collector: pytest.Collector) -> None:
    """Compare only text in notebooks whose metadata says `workbook.compare: text`."""
    if isinstance(collector, IPyNbFile):
        try:
            metadata = json.loads(collector.path.read_text(encoding="utf-8"))["metadata"]
        except (ValueError, KeyError, TypeError):
            return  # nbval says what is wrong with it
        if metadata.get("workbook", {}).get("compare") == "text":
            collector.skip_compare += NOT_TEXT


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Generator[None, object, object]:
    """Run a cell with display updates applied.

    Raises:
        NbCellError: the cell uses a magic that does not exist, or shows a number outside of its range.
    """
    if not isinstance(item, IPyNbCell):
        return (yield)
    sanitize = item.sanitize
    item.sanitize = lambda text: sanitize(_comparable(text) if isinstance(text, str) else text)
    notebook: Any = item.parent
    ask = notebook.get_kernel_message
    notebook.get_kernel_message = LiveOutputs(ask, lambda: item.test_outputs)
    try:
        result = yield
    finally:
        notebook.get_kernel_message = ask
    for output in item.test_outputs or ():
        if output.get("name") == "stderr" and output["text"].startswith(NO_MAGIC):
            raise NbCellError(item.cell_num, output["text"].strip(), item.cell.source)
        for line in (line for text in texts(output) for line in text.splitlines() if UNUSUAL in line):
            raise NbCellError(item.cell_num, f"A number is outside of its range: {line}", item.cell.source)
    return result


def _comparable(text: str) -> str:
    return without_numbers(without_pictures(text))


class KernelInAnEmptyFolder(PrivateKernelManager):
    """Run the kernel in a folder that goes when the kernel is shut down, as do the files that a notebook writes."""

    def start_kernel(self, **options: Any) -> None:
        """Start the kernel there, wherever its notebook is."""
        self._folder = Path(tempfile.mkdtemp(prefix="notebook-"))
        super().start_kernel(**{**options, "cwd": str(self._folder)})

    def cleanup_connection_file(self) -> None:
        """Remove the folder as well."""
        super().cleanup_connection_file()
        shutil.rmtree(self._folder, ignore_errors=True)


class LiveOutputs:
    """Hands on a kernel's messages, and applies display updates and clearing to the outputs collected so far."""

    def __init__(self, ask: Callable[..., dict[str, Any]], outputs: Callable[[], list[Any]]) -> None:
        self._ask = ask
        self._outputs = outputs
        self._places: dict[str, int] = {}
        self._clear_next = False

    def __call__(self, timeout: float | None = None, stream: str = "iopub") -> dict[str, Any]:
        while True:
            message = self._ask(timeout=timeout, stream=stream)
            kind, content = message["msg_type"], message["content"]
            if kind == "update_display_data":
                self._update(content)
            elif kind == "clear_output":
                self._clear_next = True
                if not content.get("wait"):
                    self._clear()
            else:
                if kind in OUTPUTS:
                    if self._clear_next:
                        self._clear()
                    self._note(content)
                return message

    def _note(self, content: dict[str, Any]) -> None:
        name = content.get("transient", {}).get("display_id")
        if name is not None:
            self._places[name] = len(self._outputs())

    def _update(self, content: dict[str, Any]) -> None:
        place = self._places.get(content.get("transient", {}).get("display_id", ""))
        outputs = self._outputs()
        if place is not None and place < len(outputs):
            outputs[place]["data"] = nbformat.from_dict(content["data"])

    def _clear(self) -> None:
        self._outputs().clear()
        self._places.clear()
        self._clear_next = False
