"""A pytest plugin that makes nbval compare the outputs that JupyterLab would show.

By itself, nbval drops display updates and keeps cleared outputs, so a moving figure would never equal the committed
one. This plugin applies updates and clearing as they arrive. It doesn't compare images inside HTML. Numbers marked as
varying (`≈ 23 ms`) count as equal, but a cell fails if one of them is outside its range.

The plugin also sets the sanitize file, unless another one is given. In notebooks whose metadata says
`workbook.compare: text`, it compares only text. A cell fails if it uses a magic that doesn't exist. Kernels communicate
over Unix sockets and run in an empty folder, so that they leave nothing in the checkout. Each notebook gets its own
answers folder unless WORKBOOK_ANSWERS is set. Moving figures are drawn only twice a second, because a comparison has no
viewers. If WORKBOOK_RAN names a notebook that was run elsewhere, the plugin compares that notebook's outputs and
doesn't start a kernel.
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
from workbook.lesson.robot_in_cell import ROBOT
from workbook.ros.scratch import sweep_scratch

OUTPUTS = ("display_data", "execute_result", "stream", "error")
NOT_TEXT = ("text/html", "text/markdown", "image/svg+xml")
NO_MAGIC = "UsageError:"
ANSWERS = "WORKBOOK_ANSWERS"
MOST_PICTURES = "WORKBOOK_PICTURES_PER_SECOND"
_own_folder = pytest.StashKey[Path]()


def pytest_configure(config: pytest.Config) -> None:
    """Make kernels use Unix sockets, set the sanitize file, and limit live views to two images per second."""
    nbval.kernel.KernelManager = KernelInAnEmptyFolder
    ran = os.environ.get(RAN)
    if ran:
        nbval.plugin.RunningKernel = lambda *_, **__: Replay(Path(ran))
    os.environ.setdefault(MOST_PICTURES, "2")
    gc.freeze()  # otherwise, a kernel's messages would make the collector scan the loaded modules again and again
    if getattr(config.option, "nbval_sanitize_with", SANITIZE) is None:
        config.option.nbval_sanitize_with = str(SANITIZE)


def pytest_unconfigure(config: pytest.Config) -> None:
    """Remove this run's answers folder, and the files that killed kernels left in temporary folders."""
    folder = config.stash.get(_own_folder, None)
    if folder is not None:
        shutil.rmtree(folder, ignore_errors=True)
    sweep_scratch()  # nbval kills its kernels


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    """Give each notebook its own answers folder unless WORKBOOK_ANSWERS is set, and leave predictions unanswered."""
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
    """Compare only text in notebooks whose metadata says `workbook.compare: text`. Never compare the live robot."""
    if isinstance(collector, IPyNbFile):
        collector.skip_compare += (ROBOT,)  # this output contains its kernel's ID
        try:
            metadata = json.loads(collector.path.read_text(encoding="utf-8"))["metadata"]
        except (ValueError, KeyError, TypeError):
            return  # nbval reports what is wrong with the file
        if metadata.get("workbook", {}).get("compare") == "text":
            collector.skip_compare += NOT_TEXT


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Generator[None, object, object]:
    """Run a cell and apply its display updates to the outputs that nbval compares.

    Raises:
        NbCellError: the cell uses a magic that doesn't exist, or shows a number outside its range.
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
    """A kernel manager whose kernel runs in an empty folder. The folder is deleted when the kernel shuts down."""

    def start_kernel(self, **options: Any) -> None:
        """Start the kernel in a new folder instead of the notebook's."""
        self._folder = Path(tempfile.mkdtemp(prefix="notebook-"))
        super().start_kernel(**{**options, "cwd": str(self._folder)})

    def cleanup_connection_file(self) -> None:
        """Remove the connection file, the sockets, and the kernel's folder."""
        super().cleanup_connection_file()
        shutil.rmtree(self._folder, ignore_errors=True)


class LiveOutputs:
    """Passes on a kernel's messages, and applies display updates and clearing to the collected outputs."""

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
