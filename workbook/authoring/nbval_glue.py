"""A pytest plugin that lets nbval see what JupyterLab shows.

nbval by itself drops updates of a display and piles up cleared outputs, so that a picture that moves never equals
the one committed. This plugin applies both as they come, sets the sanitize file unless another is given, and
compares only text in notebooks whose metadata says `workbook.compare: text`.
"""

import json
from collections.abc import Callable, Generator
from typing import Any

import nbformat
import pytest
from nbval.plugin import IPyNbCell, IPyNbFile

from workbook.authoring.outputs import SANITIZE

OUTPUTS = ("display_data", "execute_result", "stream", "error")
NOT_TEXT = ("text/html", "text/markdown", "image/svg+xml")


def pytest_configure(config: pytest.Config) -> None:
    if getattr(config.option, "nbval_sanitize_with", SANITIZE) is None:
        config.option.nbval_sanitize_with = str(SANITIZE)


def pytest_collectstart(collector: pytest.Collector) -> None:
    if isinstance(collector, IPyNbFile):
        try:
            metadata = json.loads(collector.path.read_text(encoding="utf-8"))["metadata"]
        except (ValueError, KeyError, TypeError):
            return  # nbval says what is wrong with it
        if metadata.get("workbook", {}).get("compare") == "text":
            collector.skip_compare += NOT_TEXT


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Generator[None, object, object]:
    if not isinstance(item, IPyNbCell):
        return (yield)
    notebook: Any = item.parent
    ask = notebook.get_kernel_message
    notebook.get_kernel_message = LiveOutputs(ask, lambda: item.test_outputs)
    try:
        return (yield)
    finally:
        notebook.get_kernel_message = ask


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
